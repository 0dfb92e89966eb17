#include "gui/frame/palette_entries.h"

#include <fmt/format.h>

#include "gui/panels/lesson/lesson_list.h"
#include "gui/panels/options/value_entries.h"
#include "gui/session/compare_technique.h"
#include "gui/widgets/key_focus.h"
#include "options/option.h"
#include "scene/load.h"
#include "study/stability/experiment.h"

namespace ps::gui {
namespace {

/// The side whose picture an option acts on: the picked one, unless it acts on the other alone.
Side side_that_it_acts_on(const Session& session, const Option& option) {
  const Side picked = session.document().picked, other = other_side(picked);
  const auto acts = [&](Side side) { return !inactive_reason(option, session.settings(side), session.traits()); };
  return !acts(picked) && acts(other) ? other : picked;
}

}  // namespace

std::vector<PaletteEntry> palette_entries(const PanelHost& host, const PanelList& panels) {
  Session& session = host.session;
  std::vector<PaletteEntry> entries;
  for (const ListedLesson& lesson : listed_lessons())
    if (lesson.fault.empty())
      entries.push_back({"lesson/" + lesson.name, lesson.title, "lesson",
                         [&session, &lesson] { go_to_step(session, lesson.name, 0); }});
  for (const Option& option : option_table())
    entries.push_back(
        {fmt::format("option/{}", option.key), fmt::format("{}: {}", option.group, option.label), "option",
         [&session, &host, &option] {
           host.send(PointAtOption{&option});
           host.send(ShowOptions{});
           key_focus().go_to(
               fmt::format("options/{}/{}", side_that_it_acts_on(session, option) == Side::a ? "a" : "b", option.key));
         },
         fmt::format("{}, {}", option.key, option.keywords)});
  for (PaletteEntry& entry : value_entries(session)) entries.push_back(std::move(entry));
  for (Panel& panel : panels) panel.add_entries(entries);
  for (const Technique& technique : technique_table())
    for (const TechniqueChoice& choice : technique.choices)
      entries.push_back({fmt::format("technique/{}/{}", technique.key, choice.key),
                         technique_command(technique, choice), "compare",
                         [&session, &technique, &choice] { compare_technique(session, technique, choice); },
                         fmt::format("compare, {}, {}", technique.label, technique.keywords)});
  for (const BuiltinScene& scene : builtin_scenes())
    entries.push_back({"scene/" + scene.name, scene.title, "scene", [&session, &scene] { session.open(scene.name); },
                       scene.name + ", " + scene.keywords});
  for (const StabilityExperiment& experiment : stability_experiments())
    entries.push_back({fmt::format("experiment/{}", experiment.key), std::string(experiment.title), "experiment",
                       [&session, &host, &experiment] {
                         host.send(ShowTool{"stability"});
                         session.navigate([&](Document& document) { document.layout.experiment = experiment.key; });
                       },
                       fmt::format("{}, {}", experiment.key, experiment.keywords)});
  return entries;
}

}  // namespace ps::gui
