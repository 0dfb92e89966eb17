#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/enumerators.h"
#include "base/spelling.h"
#include "document/number_list.h"
#include "document/permalink.h"
#include "engine/block.h"
#include "engine/course.h"
#include "engine/screen_names.h"
#include "engine/words.h"
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

/// A presenter chooses that mode, a step cannot.
ScreenMode parse_step_mode(const std::string& text) {
  const ScreenMode mode = parse_enumerator<ScreenMode>("mode", text);
  if (mode == ScreenMode::presenter) throw InputError("mode: found 'presenter', expected lesson explore study");
  return mode;
}

std::string parse_stage(const std::string& text) {
  std::vector<std::string_view> known(tool_names::all.begin(), tool_names::all.end());
  known.insert(known.end(), {story_names::one, pictures_stage});
  if (std::find(known.begin(), known.end(), text) == known.end())
    throw InputError(fmt::format("stage: found '{}', expected {}", text, expected_word(text, known)));
  return text;
}

/// A file that starts with "./" lies in the lesson's own folder.
std::string file_of(const BlockLine& line) {
  if (line.rest.rfind("./", 0) != 0) return line.rest;
  return (std::filesystem::path(line.place.file).parent_path() / line.rest.substr(2)).string();
}

/// The words of a step for parts that permalinks name otherwise.
std::string part_key(const std::string& word, std::string& value) {
  if (word == "show") return "show-a";
  if (word == "slow-motion") return "slow-motion-a";
  if (word != "edit") return word;
  std::string_view rest = value;
  std::string key = "edit.";
  key += take_word(rest);
  if (rest.empty()) throw InputError(fmt::format("edit: found '{}', expected a property and its value", value));
  value = std::string(rest);
  return key;
}

void apply_parts(const std::vector<StatePart>& parts, Document& document) {
  for (const StatePart& part : parts)
    if (!set_permalink_part(document, part.key, part.value))
      throw InputError(fmt::format("unknown word '{}'", part.key));
}

/// Adds a part, or changes the one of its key in its place: those behind it may need it before them (pin.size
/// needs pin).
void set_part(std::vector<StatePart>& parts, std::string_view key, std::string_view value) {
  const auto known = std::find_if(parts.begin(), parts.end(), [&](const StatePart& part) { return part.key == key; });
  if (known == parts.end())
    parts.push_back({std::string(key), std::string(value)});
  else
    known->value = value;
}

/// Takes a part over into the state. Gives false if permalinks have none of this name.
bool add_part(const BlockLine& line, LessonState& state) {
  std::string value = line.rest;
  const std::string key = part_key(line.word, value);
  if (key == "lesson" || key == "step") return false;
  if (key == "picture-b") value = file_of(line);
  std::vector<StatePart> parts = state.parts;
  set_part(parts, key, value);
  Document trial;
  for (const StatePart& part : parts)
    if (!set_permalink_part(trial, part.key, part.value)) return false;
  state.parts = std::move(parts);
  return true;
}

/// Whether a state arranges the window, which the step after it does not take over.
bool arranges_window(const LessonState& state) {
  Document trial;
  apply_parts(state.parts, trial);
  return !(trial.layout == Layout{});
}

}  // namespace

const std::string* part_of(const LessonState& state, std::string_view key) {
  const auto part =
      std::find_if(state.parts.begin(), state.parts.end(), [&](const StatePart& each) { return each.key == key; });
  return part == state.parts.end() ? nullptr : &part->value;
}

bool changes_anything(const LessonState& state) {
  return !state.scene.empty() || !state.set_a.empty() || !state.set_b.empty() || !state.parts.empty();
}

bool read_state_line(const BlockLine& line, LessonState& state) {
  const std::string& rest = line.rest;
  if (line.word == "scene")
    state.scene = file_of(line);
  else if (line.word == "set")
    add_setting(rest, state.set_a);
  else if (line.word == "set-b")
    add_setting(rest, state.set_b);
  else if (line.word == "set-both") {
    add_setting(rest, state.set_a);
    add_setting(rest, state.set_b);
  } else if (line.word == "mode")
    state.mode = parse_step_mode(rest);
  else if (line.word == "stage")
    state.stage = parse_stage(rest);
  else if (line.word == "sweep") {
    set_part(state.parts, "sweep", rest == model_sweep_key ? std::string(rest) : sweep_text(parse_sweep_text(rest)));
    state.stage = tool_names::chart;
  } else if (line.word == "experiment") {
    set_part(state.parts, "experiment", find_stability_experiment(rest).key);
    state.stage = tool_names::stability;
  } else
    return add_part(line, state);
  return true;
}

void change_document(const LessonState& change, Document& document) {
  Document changed = document;
  for (const std::string& assignment : change.set_a) parse_assignment(assignment, changed.a.settings);
  for (const std::string& assignment : change.set_b) parse_assignment(assignment, changed.b.settings);
  apply_parts(change.parts, changed);
  attach_scene(changed, changed.base);
  document = std::move(changed);
}

Document state_document(const LessonState& state, const Document& now) {
  const bool same_scene = now.scene_name == state.scene && !state.scene.empty();
  Document document = open_document(state.scene, same_scene ? now.base : load_scene(state.scene));
  document.a.settings = document.b.settings = settings_for(document.base);
  if (part_of(state, "size")) document.pixel = {-1, -1};  // the start pixel is one of the canvas size
  document.layout = now.layout;
  const bool tool = std::find(tool_names::all.begin(), tool_names::all.end(), state.stage) != tool_names::all.end();
  if (tool) document.layout.bottom_tab = state.stage;
  if (tool && document.layout.bottom <= 0) document.layout.bottom = opened_share;
  document.story = carried_over(now.story, same_scene);
  change_document(state, document);
  return document;
}

Document linked_document(std::string_view link) {
  Document document = parse_permalink(link);
  if (const auto now = successor_of({document.lesson, document.step}); now && !document.lesson.empty()) {
    document.lesson = now->lesson;
    document.step = now->step;
  }
  if (document.scene_name.empty() && !document.lesson.empty()) {
    const Lesson lesson = load_lesson(document.lesson);
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    return lesson_document(lesson, std::min(document.step, last), document);
  }
  attach_scene(document, load_scene(document.scene_name));
  return document;
}

Document lesson_document(const Lesson& lesson, int step, const Document& now) {
  PS_ASSERT(step >= 0 && static_cast<std::size_t>(step) < lesson.steps.size(), "a step of the lesson");
  const LessonState& state = lesson.steps[static_cast<std::size_t>(step)].state;
  Document before = now;
  const bool from_here = now.lesson == lesson.name && static_cast<std::size_t>(now.step) < lesson.steps.size();
  if (from_here && arranges_window(lesson.steps[static_cast<std::size_t>(now.step)].state))
    before.layout.filled.clear();
  Document document = state_document(state, before);
  document.lesson = lesson.name;
  document.step = step;
  document.mode = now.mode == ScreenMode::presenter ? ScreenMode::presenter : state.mode;
  document.layout.stage = state.stage;
  return document;
}

}  // namespace ps
