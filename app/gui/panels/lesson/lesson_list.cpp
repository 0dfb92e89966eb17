#include "gui/panels/lesson/lesson_list.h"

#include <fmt/format.h>

#include "base/check.h"
#include "engine/course.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// The course, or one without parts where it cannot be read.
Course readable_course() {
  try {
    return load_course();
  } catch (const InputError&) {
    return {};
  }
}

struct ReadableLessons {
  std::vector<ListedLesson> listed;
  std::vector<Lesson> texts;  ///< in the same order; empty ones where a lesson cannot be read
};

ReadableLessons read_lessons() {
  ReadableLessons all;
  const Course course = readable_course();
  for (const auto& name : lesson_names()) {
    ListedLesson& listed = all.listed.emplace_back();
    Lesson& lesson = all.texts.emplace_back();
    listed.name = listed.title = name;
    listed.part = part_title(course, name);
    try {
      lesson = load_lesson(name);
      listed.title = lesson.title;
      listed.source = lesson.source;
      listed.length = length_of(lesson);
      for (const LessonStep& step : lesson.steps) listed.steps.push_back(step.title);
    } catch (const InputError& error) {
      listed.fault = error.what();
    }
  }
  return all;
}

const ReadableLessons& readable_lessons() {
  static const ReadableLessons lessons = read_lessons();
  return lessons;
}

LessonIndex index_lessons() {
  LessonIndex index;
  for (const Lesson& lesson : readable_lessons().texts) index.add(lesson);
  return index;
}

}  // namespace

const std::vector<ListedLesson>& listed_lessons() { return readable_lessons().listed; }

const LessonIndex& lesson_index() {
  static const LessonIndex index = index_lessons();
  return index;
}

std::string lesson_tooltip(const ListedLesson& lesson, const ReadLessons& read) {
  return fmt::format("{}\n{}{}", lesson.source, read.names.contains(lesson.name) ? "Read to the end; " : "",
                     length_text(lesson.length));
}

std::string short_length(const LessonLength& length) {
  return fmt::format("{} step{}, {} min", length.steps, length.steps == 1 ? "" : "s", length.minutes());
}

bool lesson_list(Session& session, const ReadLessons& read) {
  const NameScope scope("lessons");
  const bool find = button("find", "Find in all lessons", Emphasis::primary,
                           {.tooltip = "Pictures of all lessons, and a search in their texts."});
  ImGui::BeginChild("lessons");
  std::string_view part;
  for (const ListedLesson& lesson : listed_lessons()) {
    if (!lesson.fault.empty()) continue;  // the lesson menu says what is wrong with it
    if (lesson.part != part) {
      part = lesson.part;
      show_text(lesson.part, {.quiet = true});
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string text = lesson.title + "   " + short_length(lesson.length);
    if (tree_row(lesson.name, text, TreeKind::leaf, false).clicked) go_to_step(session, lesson.name, 0);
    const bool is_read = read.names.contains(lesson.name);
    tooltip(lesson_tooltip(lesson, read));
    if (is_read) draw_tick(at, ImGui::GetItemRectSize().y);
    controls().record(lesson.name + "/read", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), is_read ? "on" : "off");
  }
  ImGui::EndChild();
  return find;
}

}  // namespace ps::gui
