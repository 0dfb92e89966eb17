#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <system_error>

#include "added_renderers.h"
#include "base/check.h"
#include "base/failure_text.h"
#include "base/foreign_text.h"
#include "base/progress.h"
#include "base/quoted_line.h"
#include "base/spelling.h"
#include "base/standard_output.h"
#include "base/version.h"
#include "cli/command.h"
#include "cli/interrupt.h"

namespace {

constexpr int check_failed = 1;
constexpr int bad_input = 2;

/// One line on standard error, whatever the message, and not all of a long one; behind it what is quoted of a file.
int fail(std::string message, int status, const std::string& quoted = {}) {
  constexpr std::size_t longest = 4000;
  if (message.size() > longest) message = message.substr(0, longest) + "...";
  std::replace_if(
      message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  message = ps::foreign_text(message + quoted);                              // it may quote a file
  std::fputs(fmt::format("pixelscope-cli: {}\n", message).c_str(), stderr);  // fmt::print would throw where that fails
  return status;
}

/// Reads the command line. Gives the exit status if no work is left.
std::optional<int> parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return {};
  } catch (const CLI::RequiredError& error) {
    if (argc > 1 && app.get_subcommands().empty())
      return fail(fmt::format("unknown command '{}'; --help lists them", ps::shown_start(argv[1])), bad_input);
    return fail(error.what(), bad_input);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help and version
    return fail(error.what(), bad_input);
  }
}

/// Does the work: 130 and 2 for work that was stopped or failed.
int act(const ps::cli::Action& action) {
  try {
    return action();
  } catch (const ps::Cancelled&) {
    ps::cli::say_stopped();
    return ps::cli::interrupted;
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) return fail(ps::unprinted_text(error.code().value()), bad_input);
    return fail(ps::failure_text(error), bad_input);
  } catch (const std::exception& error) {
    return fail(ps::failure_text(error), bad_input, ps::quoted_lines(error));
  }
}

}  // namespace

int main(int argc, char** argv) {
  ps::open_standard_streams();
  ps::add_renderers();
  CLI::App app{"Renders scenes, shows the story of a pixel and checks the lessons, without a window."};
  app.name("pixelscope-cli");
  app.set_version_flag("--version", std::string(ps::version()));
  app.require_subcommand(1);
  ps::cli::Action action;
  ps::cli::add_render_command(app, action);
  ps::cli::add_inspect_command(app, action);
  ps::cli::add_compare_command(app, action);
  ps::cli::add_chart_command(app, action);
  ps::cli::add_renderers_command(app, action);
  ps::cli::add_needs_command(app, action);
  ps::cli::add_stability_command(app, action);
  ps::cli::add_precision_command(app, action);
  ps::cli::add_causes_command(app, action);
  ps::cli::add_missing_command(app, action);
  ps::cli::add_lessons_command(app, action);
  ps::cli::add_listing_command(app, action);
  ps::cli::add_options_command(app, action);
  ps::cli::add_scenes_command(app, action);
  try {
    const auto ended = parse(app, argc, argv);
    const int status = ended ? *ended : act(action);
    if (status <= check_failed) ps::require_printed();  // else there is a message already
    return status;
  } catch (const ps::InputError& error) {
    return fail(error.what(), bad_input);
  }
}
