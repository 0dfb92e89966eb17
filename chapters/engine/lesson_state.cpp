#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/spelling.h"
#include "document/number_list.h"
#include "document/permalink.h"
#include "engine/block.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/stability/experiment.h"
#include "study/sweep.h"

namespace ps {
namespace {

constexpr double opened_share = 0.36;  // of the window, for a tool that a step opens where all are folded

/// Keeps an assignment after making sure that the option table takes it.
void add_setting(const std::string& assignment, std::vector<std::string>& settings) {
  Settings trial;
  parse_assignment(assignment, trial);
  settings.push_back(assignment);
}

/// Who presents chooses that mode, a step cannot.
ScreenMode parse_step_mode(const std::string& text) {
  const ScreenMode mode = parse_screen_mode(text);
  if (mode == ScreenMode::presenter) throw InputError("mode: found 'presenter', expected lesson explore study");
  return mode;
}

/// "story" is the stage that a step has if it names none.
std::string parse_stage(const std::string& text) {
  if (text == "story") return {};
  std::vector<std::string_view> known(bottom_tabs.begin(), bottom_tabs.end());
  known.insert(known.end(), {"story", pictures_stage});
  if (std::find(known.begin(), known.end(), text) == known.end())
    throw InputError(fmt::format("stage: found '{}', expected {}", text, expected_word(text, known)));
  return text;
}

/// A scene that starts with "./" lies in the lesson's own folder.
std::string scene_of(const BlockLine& line) {
  if (line.rest.rfind("./", 0) != 0) return line.rest;
  return (std::filesystem::path(line.place.file).parent_path() / line.rest.substr(2)).string();
}

}  // namespace

bool read_state_line(const BlockLine& line, LessonState& state) {
  const std::string& rest = line.rest;
  if (line.word == "scene")
    state.scene = scene_of(line);
  else if (line.word == "size")
    state.size = parse_size_text(rest);
  else if (line.word == "pixel")
    state.pixel = parse_pixel_text(rest);
  else if (line.word == "set")
    add_setting(rest, state.set_a);
  else if (line.word == "set-b")
    add_setting(rest, state.set_b);
  else if (line.word == "set-both") {
    add_setting(rest, state.set_a);
    add_setting(rest, state.set_b);
  } else if (line.word == "show")
    state.show_a = parse_shown_channel(rest);
  else if (line.word == "show-b")
    state.show_b = parse_shown_channel(rest);
  else if (line.word == "picked" && (rest == "a" || rest == "b"))
    state.picked = rest == "a" ? Side::a : Side::b;
  else if (line.word == "compare")
    state.compare = parse_compare_mode(rest);
  else if (line.word == "mode")
    state.mode = parse_step_mode(rest);
  else if (line.word == "stage")
    state.stage = parse_stage(rest);
  else if (line.word == "sweep") {
    state.sweep = sweep_text(parse_sweep_text(rest));
    state.stage = "chart";
  } else if (line.word == "experiment") {
    state.experiment = find_stability_experiment(rest).key;
    state.stage = "stability";
  } else
    return false;
  return true;
}

Document state_document(const LessonState& state, const Document& now) {
  const bool same_scene = now.scene_name == state.scene && !state.scene.empty();
  Document document = open_document(state.scene, same_scene ? now.base : load_scene(state.scene));
  const Settings start = settings_for(document.base);
  document.a.settings = document.b.settings = start;
  for (const std::string& assignment : state.set_a) parse_assignment(assignment, document.a.settings);
  for (const std::string& assignment : state.set_b) parse_assignment(assignment, document.b.settings);
  document.a.show = state.show_a;
  document.b.show = state.show_b;
  if (state.size) {
    document.view.width = state.size->x;
    document.view.height = state.size->y;
    document.pixel = {-1, -1};  // the start pixel is one of the canvas size
  }
  if (state.pixel) document.pixel = *state.pixel;
  document.picked = state.picked;
  document.compare = state.compare;
  document.layout = now.layout;
  const bool tool = std::find(bottom_tabs.begin(), bottom_tabs.end(), state.stage) != bottom_tabs.end();
  if (tool) document.layout.bottom_tab = state.stage;
  if (!state.sweep.empty()) document.layout.sweep = state.sweep;
  if (!state.experiment.empty()) document.layout.experiment = state.experiment;
  if (tool && document.layout.bottom <= 0) document.layout.bottom = opened_share;
  document.story = carried_over(now.story, same_scene);
  return document;
}

Document lesson_document(const Lesson& lesson, int step, const Document& now) {
  PS_ASSERT(step >= 0 && static_cast<std::size_t>(step) < lesson.steps.size(), "a step of the lesson");
  Document document = state_document(lesson.steps[static_cast<std::size_t>(step)].state, now);
  document.lesson = lesson.name;
  document.step = step;
  const LessonState& state = lesson.steps[static_cast<std::size_t>(step)].state;
  document.mode = now.mode == ScreenMode::presenter ? ScreenMode::presenter : state.mode;
  document.layout.stage = state.stage;
  return document;
}

}  // namespace ps
