#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

#include "base/check.h"
#include "base/version.h"
#include "gui/platform/window.h"
#include "gui/script/script.h"
#include "gui/shell/shell.h"
#include "gui/widgets/gallery.h"

namespace {

int run(int argc, char** argv) {
  CLI::App cli("Pixelscope, a microscope for pixels");
  ps::gui::ShellOptions shell_options;
  bool gallery = false;
  double scale = 0;
  std::string window_size;
  cli.set_version_flag("--version", "pixelscope " + std::string(ps::version()));
  const auto* scale_option =
      cli.add_option("--scale", scale, "Size of type and controls, 0.75 to 4")->check(CLI::Range(0.75, 4.0));
  cli.add_option("--script", shell_options.script, "Drive the window by the commands of a file, then quit");
  cli.add_flag("--widget-gallery", gallery)->group("");  // for our own tests, as is the next
  cli.add_option("--window-size", window_size)
      ->group("")
      ->check(CLI::Validator(
          [](const std::string& text) {
            const auto [width, height] = ps::gui::parse_number_pair(text, {}, 'x');
            return width >= 320 && height >= 240 && width <= 16384 && height <= 16384 ? "" : "a size such as 1024x768";
          },
          "WxH"));
  cli.parse(argc, argv);
  if (*scale_option) shell_options.scale = scale;
  if (!window_size.empty()) {
    const auto [width, height] = ps::gui::parse_number_pair(window_size, {}, 'x');
    shell_options.width = static_cast<int>(width);
    shell_options.height = static_cast<int>(height);
  }

  ps::gui::Shell shell(shell_options);
  const std::unique_ptr<ps::gui::Content> content = ps::gui::make_gallery(shell);
  return shell.run(*content);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    std::cout << success.what() << '\n';
    return 0;
  } catch (const CLI::Error& error) {
    std::cerr << "pixelscope: " << error.what() << '\n';
  } catch (const ps::InputError& error) {
    std::cerr << "pixelscope: " << error.what() << '\n';
  } catch (const ps::gui::WindowError& error) {
    std::cerr << "pixelscope: " << error.what() << '\n';
  }
  return 2;
}
