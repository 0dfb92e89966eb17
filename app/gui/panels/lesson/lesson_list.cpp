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

std::vector<ListedLesson> readable_lessons() {
  std::vector<ListedLesson> lessons;
  const Course course = readable_course();
  for (const auto& name : lesson_names()) {
    ListedLesson& listed = lessons.emplace_back();
    listed.name = listed.title = name;
    listed.part = part_title(course, name);
    try {
      const Lesson lesson = load_lesson(name);
      listed.title = lesson.title;
      listed.source = lesson.source;
      listed.length = length_of(lesson);
    } catch (const InputError& error) {
      listed.fault = error.what();
    }
  }
  return lessons;
}

}  // namespace

void draw_tick(ImVec2 row, float height) {
  const float x = row.x + px(4), y = row.y + height / 2;
  const ImVec2 points[]{{x, y}, {x + px(4), y + px(4)}, {x + px(11), y - px(5)}};
  ImGui::GetWindowDrawList()->AddPolyline(points, 3, colour_u32(palette().right_mark), ImDrawFlags_None, px(2.5));
}

const std::vector<ListedLesson>& listed_lessons() {
  static const std::vector<ListedLesson> lessons = readable_lessons();
  return lessons;
}

void lesson_list(Session& session, const ReadLessons& read) {
  const NameScope scope("lessons");
  ImGui::BeginChild("lessons");
  std::string_view part;
  for (const ListedLesson& lesson : listed_lessons()) {
    if (!lesson.fault.empty()) continue;  // the lesson menu says what is wrong with it
    if (lesson.part != part) {
      part = lesson.part;
      ImGui::TextDisabled("%s", lesson.part.c_str());
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string text =
        fmt::format("{}   {} steps, {} min", lesson.title, lesson.length.steps, lesson.length.minutes());
    if (tree_row(lesson.name, text, TreeKind::leaf, false).clicked) go_to_step(session, lesson.name, 0);
    const bool is_read = read.names.contains(lesson.name);
    tooltip(fmt::format("{}\n{}{}", lesson.source, is_read ? "Read to the end; " : "", length_text(lesson.length)));
    if (is_read) draw_tick(at, ImGui::GetItemRectSize().y);
    controls().record(lesson.name + "/read", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), is_read ? "on" : "off");
  }
  ImGui::EndChild();
}

}  // namespace ps::gui
