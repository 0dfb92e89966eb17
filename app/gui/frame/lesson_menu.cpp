#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/lesson.h"
#include "gui/frame/menu_bar.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {

namespace {

/// Room for the widest title, its minutes and the mark of the lesson that is open.
float lessons_width() {
  float title = 0;
  for (const ListedLesson& lesson : listed_lessons()) title = std::max(title, text_width("      " + lesson.title));
  return title + text_width("100 min") + 4 * ImGui::GetStyle().ItemSpacing.x + 2 * ImGui::GetFontSize() +
         ImGui::GetStyle().ScrollbarSize;
}

/// Height between here and the lower edge of the window, less `lines` of a menu and its edge.
float room_above(int lines) {
  const ImGuiViewport& window = *ImGui::GetMainViewport();
  const float below =
      static_cast<float>(lines) * ImGui::GetTextLineHeightWithSpacing() + 2 * ImGui::GetStyle().WindowPadding.y + px(8);
  return std::max(window.Pos.y + window.Size.y - ImGui::GetCursorScreenPos().y - below, px(100));
}

}  // namespace

void MenuBar::lesson_item(const ListedLesson& lesson) {
  const bool is_read = read_.names.contains(lesson.name), faulty = !lesson.fault.empty();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string minutes = faulty ? "" : fmt::format("{} min", lesson.length.minutes());
  if (menu_item("lesson/" + lesson.name, "      " + lesson.title, minutes, session_.document().lesson == lesson.name)) {
    go_to_step(session_, lesson.name, 0);
    ImGui::CloseCurrentPopup();  // entries of a list in a menu do not close it by themselves
  }
  tooltip(faulty ? lesson.fault : lesson_tooltip(lesson, read_));
  if (is_read) draw_tick(at, ImGui::GetItemRectSize().y);
}

/// All lessons, in a list of its own that scrolls where the window is low, so that the menu is seen whole.
void MenuBar::lesson_entries(int lines_below) {
  const float room = room_above(lines_below);
  const float height = lessons_height_ > 0 ? std::min(lessons_height_, room) : room;
  if (ImGui::BeginChild("lessons", {lessons_width(), height})) {
    std::string_view part;
    for (const ListedLesson& lesson : listed_lessons()) {
      if (lesson.part != part) {
        part = lesson.part;
        show_text(lesson.part, {Face::small, true});
      }
      lesson_item(lesson);
    }
    lessons_height_ = ImGui::GetCursorPosY();
  }
  ImGui::EndChild();
}

void MenuBar::lesson_menu() {
  if (!begin_menu("menu/lesson", "Lessons")) return;
  constexpr std::array below{"step-next", "step-before", "lesson-after", "lesson-before", "glossary", "lesson-close"};
  menu_action(actions_, "lessons", MenuLabel::name);
  ImGui::Separator();
  lesson_entries(static_cast<int>(below.size() + lessons_left_out().size()));
  for (const LeftOutLesson& lesson : lessons_left_out())
    show_text(fmt::format("Left out: {} needs renderer = {}, which this program was built without.", lesson.name,
                          lesson.renderer),
              {Face::small, true});
  ImGui::Separator();
  for (const char* name : below) menu_action(actions_, name, MenuLabel::name);
  end_menu();
}

}  // namespace ps::gui
