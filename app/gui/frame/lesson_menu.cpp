#include <fmt/format.h>

#include "engine/lesson.h"
#include "gui/frame/menu_bar.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/widgets/tick.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {

void MenuBar::lesson_menu() {
  if (!begin_menu("menu/lesson", "Lessons")) return;
  menu_action(actions_, "lessons");
  ImGui::Separator();
  std::string_view part;
  for (const ListedLesson& lesson : listed_lessons()) {
    if (lesson.part != part) {
      part = lesson.part;
      const FontScope font(Face::small);
      ImGui::TextDisabled("%s", lesson.part.c_str());
    }
    const bool is_read = read_.names.contains(lesson.name), faulty = !lesson.fault.empty();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string minutes = faulty ? "" : fmt::format("{} min", lesson.length.minutes());
    if (menu_item("lesson/" + lesson.name, "      " + lesson.title, minutes, session_.document().lesson == lesson.name))
      go_to_step(session_, lesson.name, 0);
    tooltip(faulty ? lesson.fault
                   : fmt::format("{}\n{}{}", lesson.source, is_read ? "Read to the end; " : "",
                                 length_text(lesson.length)));
    if (is_read) draw_tick(at, ImGui::GetItemRectSize().y);
  }
  for (const LeftOutLesson& lesson : lessons_left_out()) {
    const FontScope font(Face::small);
    ImGui::TextDisabled("Left out: %s needs renderer = %s, which this program was built without.", lesson.name.c_str(),
                        lesson.renderer.c_str());
  }
  ImGui::Separator();
  for (const char* name : {"step-next", "step-before", "lesson-after", "lesson-before", "glossary", "lesson-close"})
    menu_action(actions_, name);
  end_menu();
}

}  // namespace ps::gui
