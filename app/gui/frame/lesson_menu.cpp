#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/check.h"
#include "gui/frame/menu_bar.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

struct LessonEntry {
  std::string book, label, source;
  LessonLength length;
};

/// "Computer Graphics from Scratch" over "chapter 12: Hidden surfaces"; where the source names no chapter, the title
/// alone below the whole source.
LessonEntry lesson_entry(const Lesson& lesson) {
  const auto part = lesson.source.find(", chapter");
  if (part == std::string::npos) return {lesson.source, lesson.title, lesson.source, length_of(lesson)};
  const auto end = std::min(lesson.source.find(';'), lesson.source.size());
  return {lesson.source.substr(0, part),
          fmt::format("{}: {}", lesson.source.substr(part + 2, end - part - 2), lesson.title), lesson.source,
          length_of(lesson)};
}

}  // namespace

void MenuBar::lesson_menu() {
  if (!begin_menu("menu/lesson", "Lessons")) return;
  std::string book;
  for (const auto& name : lesson_names()) {
    static std::map<std::string, LessonEntry> entries;
    auto [entry, is_new] = entries.try_emplace(name, LessonEntry{"", name, "", {}});
    if (is_new) {
      try {
        entry->second = lesson_entry(load_lesson(name));
      } catch (const InputError& error) {
        session_.say(Message::Kind::error, error.what());
      }
    }
    const auto& [of, label, source, length] = entry->second;
    if (of != book) {
      book = of;
      const FontScope font(Face::small);
      ImGui::TextDisabled("%s", book.c_str());
    }
    const bool is_read = read_.names.contains(name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string minutes = fmt::format("{} min", length.minutes());
    if (menu_item("lesson/" + name, "      " + label, minutes, session_.document().lesson == name))
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
