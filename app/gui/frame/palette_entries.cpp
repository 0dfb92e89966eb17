#include <fmt/format.h>

#include "base/check.h"
#include "gui/frame/app.h"
#include "gui/input/actions.h"
#include "gui/panels/options/value_entries.h"
#include "options/option.h"
#include "scene/load.h"
#include "study/stability/experiment.h"

namespace ps::gui {

std::vector<PaletteEntry> App::palette_entries() {
  std::vector<PaletteEntry> entries;
  for (const auto& name : lesson_names()) {
    try {
      entries.push_back(
          {"lesson/" + name, load_lesson(name).title, "lesson", [this, name] { go_to_step(session_, name, 0); }});
    } catch (const InputError&) {
      // The lesson menu says what is wrong with it.
    }
  }
  for (const Option& option : option_table())
    entries.push_back({fmt::format("option/{}", option.key), fmt::format("{}: {}", option.group, option.label),
                       "option", [this, &option] { go_to_option(option); },
                       fmt::format("{}, {}", option.key, option.keywords)});
  for (PaletteEntry& entry : value_entries(session_)) entries.push_back(std::move(entry));
  static const std::vector<BuiltinScene> scenes = builtin_scenes();
  for (const BuiltinScene& scene : scenes)
    entries.push_back({"scene/" + scene.name, scene.title, "scene", [this, &scene] { session_.open(scene.name); },
                       scene.name + ", " + scene.keywords});
  for (const StabilityExperiment& experiment : stability_experiments())
    entries.push_back({fmt::format("experiment/{}", experiment.key), std::string(experiment.title), "experiment",
                       [this, &experiment] {
                         session_.navigate([&](Document& document) {
                           document.layout.panels = true;
                           document.layout.bottom_tab = "stability";
                           document.layout.experiment = experiment.key;
                           if (document.layout.bottom <= 0) document.layout.bottom = Layout{}.bottom;
                         });
                       },
                       fmt::format("{}, {}", experiment.key, experiment.keywords)});
  return entries;
}

void App::go_to_option(const Option& option) {
  point_at_option(options_panel_, option);
  history_.open = false;
  session_.navigate([](Document& document) {
    document.layout.panels = true;
    document.layout.filled.clear();
  });
}

}  // namespace ps::gui
