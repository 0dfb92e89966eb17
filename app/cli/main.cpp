#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <string>

#include "base/check.h"
#include "base/progress.h"
#include "base/version.h"
#include "cli/command.h"

namespace {

constexpr int bad_input = 2;
constexpr int interrupted = 130;

/// One line on standard error, whatever the message.
int fail(std::string message, int status) {
  for (char& c : message)
    if (c == '\n' || c == '\r') c = ' ';
  fmt::print(stderr, "pixelscope-cli: {}\n", message);
  return status;
}

/// Reads the command line. Gives the exit status if there is nothing left to do.
std::optional<int> parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return {};
  } catch (const CLI::RequiredError& error) {
    if (argc > 1 && app.get_subcommands().empty())
      return fail(fmt::format("unknown command '{}'; --help lists them", argv[1]), bad_input);
    return fail(error.what(), bad_input);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help and version
    return fail(error.what(), bad_input);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Renders scenes, tells the story of a pixel and checks the lessons, without a window."};
  app.name("pixelscope-cli");
  app.set_version_flag("--version", std::string(ps::version()));
  app.require_subcommand(1);
  ps::cli::Action action;
  ps::cli::add_render_command(app, action);
  ps::cli::add_inspect_command(app, action);
  ps::cli::add_compare_command(app, action);
  ps::cli::add_chart_command(app, action);
  ps::cli::add_needs_command(app, action);
  ps::cli::add_stability_command(app, action);
  ps::cli::add_precision_command(app, action);
  ps::cli::add_causes_command(app, action);
  ps::cli::add_lessons_command(app, action);
  ps::cli::add_options_command(app, action);
  ps::cli::add_scenes_command(app, action);
  if (const auto status = parse(app, argc, argv)) return *status;
  try {
    return action();
  } catch (const ps::Cancelled&) {
    return fail("stopped", interrupted);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for this", bad_input);
  } catch (const std::exception& error) {
    return fail(error.what(), bad_input);
  }
}
