#include <CLI/CLI.hpp>

#include <cstdlib>
#include <iostream>
#include <memory>
#include <new>
#include <optional>

#include "added_renderers.h"
#include "base/check.h"
#include "base/failure_text.h"
#include "base/foreign_text.h"
#include "base/quoted_line.h"
#include "base/standard_output.h"
#include "base/version.h"
#include "document/number_list.h"
#include "gui/frame/app.h"
#include "gui/gallery/gallery.h"
#include "gui/platform/end_signals.h"
#include "gui/platform/window.h"
#include "gui/script/script.h"
#include "gui/shell/shell.h"
#include "gui/work/leave.h"
#include "number_option.h"

namespace {

int run(int argc, char** argv) {
  CLI::App cli("Pixelscope, a microscope for pixels");
  ps::gui::ShellOptions shell_options;
  ps::gui::AppOptions app_options;
  std::string size;
  bool gallery = false;
  double scale = 0;
  std::string window_size;
  cli.set_version_flag("--version", "pixelscope " + std::string(ps::version()));
  const auto* scale_option =
      cli.add_option("--scale", scale, "Size of text and controls, 0.75 to 4")->check(ps::number_from(0.75, 4));
  cli.add_option("--script", shell_options.script, "Run the commands of a script file in the window, then quit");
  cli.add_option("SCENE", app_options.scene, "A .scene or .obj file, or the name of a built-in scene");
  cli.add_option("--lesson", app_options.lesson, "NAME or NAME/STEP: open a lesson, at a step counted from 1");
  cli.add_option("--set", app_options.set, "KEY=VALUE: an option of picture A; may be repeated")
      ->allow_extra_args(false);
  cli.add_option("--set-b", app_options.set_b, "KEY=VALUE: an option of picture B")->allow_extra_args(false);
  cli.add_option("--permalink", app_options.permalink, "Open the state stored in a permalink")->excludes("SCENE");
  cli.add_option("--size", size, "Size of the pictures in pixels, WIDTHxHEIGHT");
  cli.add_flag("--widget-gallery", gallery)->group("");  // for our own tests, as is the next
  cli.add_option("--window-size", window_size)
      ->group("")
      ->check(CLI::Validator(
          [](const std::string& text) {
            const auto [width, height] = ps::gui::parse_number_pair(text, {}, 'x');
            return width >= 320 && height >= 240 && width <= 16384 && height <= 16384 ? "" : "a size such as 1024x768";
          },
          "WxH"));
  try {
    cli.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << cli.help();
    ps::require_printed();
    return 0;
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << '\n';
    ps::require_printed();
    return 0;
  }
  if (*scale_option) shell_options.scale = scale;
  if (!window_size.empty()) {
    const auto [width, height] = ps::gui::parse_number_pair(window_size, {}, 'x');
    shell_options.size = ps::gui::WindowSize{static_cast<int>(width), static_cast<int>(height)};
  }

  if (!size.empty()) {
    const ps::Vec2i wanted = ps::parse_size_text(size);
    app_options.width = wanted.x;
    app_options.height = wanted.y;
  }
  app_options.remember = shell_options.script.empty() || std::getenv("XDG_STATE_HOME");

  std::optional<ps::Document> document;
  if (!gallery) document = ps::gui::first_document(app_options);  // bad input ends here, before a window opens
  ps::gui::Shell shell(shell_options);
  if (gallery) return shell.run(*ps::gui::make_gallery(shell));
  ps::gui::App app(shell, app_options, std::move(*document));
  const int status = shell.run(app);
  ps::gui::leave_soon(status);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  ps::open_standard_streams();
  ps::add_renderers();
  ps::gui::watch_end_signals();
  try {
    return run(argc, argv);
  } catch (const CLI::Error& error) {
    std::cerr << "pixelscope: " << error.what() << '\n';
  } catch (const std::exception& error) {  // InputError, WindowError and what a library throws
    std::cerr << "pixelscope: " << ps::foreign_text(ps::failure_text(error) + ps::quoted_lines(error)) << '\n';
  }
  return 2;
}
