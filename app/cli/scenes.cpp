#include <fmt/format.h>

#include "cli/command.h"
#include "scene/load.h"

namespace ps::cli {
namespace {

int run_scenes() {
  for (const BuiltinScene& scene : builtin_scenes()) {
    fmt::print("{:<22} {}\n", scene.name, scene.title);
    if (!scene.description.empty()) fmt::print("{:<22} {}\n", "", scene.description);
  }
  return 0;
}

}  // namespace

void add_scenes_command(CLI::App& app, Action& chosen) {
  app.add_subcommand("scenes", "list the built-in scenes")->callback([&chosen] { chosen = run_scenes; });
}

}  // namespace ps::cli
