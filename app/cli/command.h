#pragma once
#include <CLI/CLI.hpp>

#include <functional>

namespace ps::cli {

/// The work of a subcommand once its arguments are read. Gives the exit status: 0 done, 1 the check failed. Bad input
/// is thrown as InputError.
using Action = std::function<int()>;

/// Each adds one subcommand to `app`; when the user picks it, parsing puts its action into `chosen`.
void add_render_command(CLI::App& app, Action& chosen);
void add_inspect_command(CLI::App& app, Action& chosen);
void add_compare_command(CLI::App& app, Action& chosen);
void add_chart_command(CLI::App& app, Action& chosen);
void add_renderers_command(CLI::App& app, Action& chosen);
void add_needs_command(CLI::App& app, Action& chosen);
void add_stability_command(CLI::App& app, Action& chosen);
void add_precision_command(CLI::App& app, Action& chosen);
void add_causes_command(CLI::App& app, Action& chosen);
void add_missing_command(CLI::App& app, Action& chosen);
void add_lessons_command(CLI::App& app, Action& chosen);
void add_listing_command(CLI::App& app, Action& chosen);
void add_options_command(CLI::App& app, Action& chosen);
void add_scenes_command(CLI::App& app, Action& chosen);

}  // namespace ps::cli
