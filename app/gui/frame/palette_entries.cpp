#include "gui/frame/palette_entries.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/frame/absent_features.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/panels/options/value_entries.h"
#include "gui/session/compare_technique.h"
#include "gui/widgets/key_focus.h"
#include "options/option.h"
#include "options/waking.h"
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

/// The words of a choice among several lead to it before the words of them all do.
std::string search_words(const Technique& technique, const TechniqueChoice& choice) {
  if (technique.choices.size() == 1) return fmt::format("{}, {}", technique.label, technique.keywords);
  std::string all(technique.keywords);
  std::erase(all, ',');
  return fmt::format("{}, {} {}", choice.label, technique.label, all);
}

/// "far origin" for "lab/far-origin".
std::string name_in_words(const std::string& scene) {
  std::string words = scene.substr(scene.find('/') + 1);
  std::replace(words.begin(), words.end(), '-', ' ');
  return words;
}

void add_lessons(std::vector<PaletteEntry>& entries, Session& session) {
  for (const ListedLesson& lesson : listed_lessons()) {
    if (!lesson.fault.empty()) continue;
    entries.push_back({"lesson/" + lesson.name, lesson.title, "lesson",
                       [&session, &lesson] { go_to_step(session, lesson.name, 0); }, "lesson"});
  }
  for (const ListedLesson& lesson : listed_lessons())
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
      entries.push_back({fmt::format("step/{}/{}", lesson.name, i + 1),
                         fmt::format("{}: {}", lesson.title, lesson.steps[i]), "step",
                         [&session, &lesson, i] { go_to_step(session, lesson.name, static_cast<int>(i)); }});
}

void add_options(std::vector<PaletteEntry>& entries, Session& session, const PanelHost& host) {
  for (const Option& option : option_table())
    entries.push_back(
        {fmt::format("option/{}", option.key), fmt::format("{}: {}", option.group, option.label), "option",
         [&session, &host, &option] {
           host.send(PointAtOption{&option});
           host.send(ShowOptions{});
           const Side side = side_that_it_acts_on(session, option);
           // Where the value has no effect yet, Enter sets what it needs; then the keyboard is at the value.
           const bool asleep = !waking_of(option, session.settings(side), session.traits()).settings.empty();
           key_focus().go_to(
               fmt::format("options/{}/{}{}", side == Side::a ? "a" : "b", option.key, asleep ? "/wake" : ""));
         },
         fmt::format("{}, {}, {}", option.label, option.key, option.keywords)});
}

}  // namespace

std::vector<PaletteEntry> palette_entries(const PanelHost& host, const PanelList& panels) {
  Session& session = host.session;
  std::vector<PaletteEntry> entries;
  const auto shown = session.shown_technique();
  for (const Technique& technique : technique_table())
    for (const TechniqueChoice& choice : technique.choices) {
      const bool on = shown && &technique_table()[shown->technique].choices[shown->choice] == &choice;
      entries.push_back({fmt::format("technique/{}/{}", technique.key, choice.key),
                         technique_command(technique, choice) + (on ? " (once more: back)" : ""), "compare",
                         [&session, &technique, &choice] { compare_technique(session, technique, choice); },
                         search_words(technique, choice)});
    }
  for (PaletteEntry& entry : channel_entries(session)) entries.push_back(std::move(entry));
  add_options(entries, session, host);
  for (PaletteEntry& entry : value_entries(session)) entries.push_back(std::move(entry));
  add_lessons(entries, session);
  for (const BuiltinScene& scene : builtin_scenes())
    entries.push_back({"scene/" + scene.name, scene.title, "scene", [&session, &scene] { session.open(scene.name); },
                       fmt::format("{}, {}, {}", scene.name, name_in_words(scene.name), scene.keywords)});
  for (Panel& panel : panels) panel.add_entries(entries);
  for (const StabilityExperiment& experiment : stability_experiments())
    entries.push_back({fmt::format("experiment/{}", experiment.key), std::string(experiment.title), "experiment",
                       [&session, &host, &experiment] {
                         host.send(ShowTool{"stability"});
                         session.navigate([&](Document& document) { document.layout.experiment = experiment.key; });
                       },
                       fmt::format("{}, {}", experiment.key, experiment.keywords)});
  for (const AbsentFeature& absent : absent_features())
    entries.push_back({.name = fmt::format("missing/{}", absent.name),
                       .label = fmt::format("No {} here. Nearest: {}", absent.name, absent.nearest),
                       .kind = "not here",
                       .words = fmt::format("{}, {}", absent.name, absent.words),
                       .leads_to = std::string(absent.leads_to)});
  return entries;
}

}  // namespace ps::gui
