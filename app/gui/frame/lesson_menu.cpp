#include <fmt/format.h>

#include <map>

#include "base/check.h"
#include "engine/course.h"
#include "gui/frame/menu_bar.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

struct LessonEntry {
  std::string title, source;
  std::string part;  // of the course
  LessonLength length;
};

/// The entries by the names of their lessons. What cannot be read is reported and has its name as title.
std::map<std::string, LessonEntry> lesson_entries(Session& session) {
  const auto reported = [&](const auto& read) {
    try {
      read();
    } catch (const InputError& error) {
      session.say(Message::Kind::error, error.what());
    }
  };
  Course course;
  reported([&] { course = load_course(); });
  std::map<std::string, LessonEntry> entries;
  for (const std::string& name : lesson_names()) {
    LessonEntry& entry = entries[name] = {name, "", std::string(part_title(course, name)), {}};
    reported([&] {
      const Lesson lesson = load_lesson(name);
      entry = {lesson.title, lesson.source, entry.part, length_of(lesson)};
    });
  }
  return entries;
}

}  // namespace

void MenuBar::lesson_menu() {
  if (!begin_menu("menu/lesson", "Lessons")) return;
  static const std::map<std::string, LessonEntry> entries = lesson_entries(session_);
  std::string part;
  for (const auto& name : lesson_names()) {
    const auto& [title, source, of, length] = entries.at(name);
    if (of != part) {
      part = of;
      const FontScope font(Face::small);
      ImGui::TextDisabled("%s", part.c_str());
    }
    const bool is_read = read_.names.contains(name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string minutes = fmt::format("{} min", length.minutes());
    if (menu_item("lesson/" + name, "      " + title, minutes, session_.document().lesson == name))
      go_to_step(session_, name, 0);
    tooltip(fmt::format("{}\n{}{}", source, is_read ? "Read to the end; " : "", length_text(length)));
    if (is_read) draw_tick(at, ImGui::GetItemRectSize().y);
  }
  ImGui::Separator();
  for (const char* name : {"step-next", "step-before", "lesson-after", "lesson-before", "glossary", "lesson-close"})
    menu_action(actions_, name);
  end_menu();
}

}  // namespace ps::gui
