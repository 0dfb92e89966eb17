#pragma once
#include <string_view>
#include <vector>

#include "gui/frame/about.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/panels/panel.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The row at the upper edge: menus, the scene's name, and how the pictures are compared. All that it works on must
/// outlive it.
class MenuBar {
 public:
  MenuBar(Session& session, const Actions& actions, const PanelList& panels, About& about, const ReadLessons& read,
          const CompareMode& shown)
      : session_(session), actions_(actions), panels_(panels), about_(about), read_(read), shown_(shown) {}
  void draw();

 private:
  void scene_menu();
  void lesson_menu();
  void lesson_item(const ListedLesson& lesson);
  void lesson_entries(int lines_below);
  void view_menu();
  void study_menu();
  void main_menu();
  void help_menu();
  void bar_button(std::string_view action, std::string_view label);
  float compare_buttons_width() const;
  void compare_buttons(float left);

  Session& session_;
  const Actions& actions_;
  const PanelList& panels_;
  About& about_;
  const ReadLessons& read_;
  const CompareMode& shown_;  ///< how the pictures are arranged, which the window's size may change
  float lessons_height_ = 0;  ///< of the list in the menu, when it was drawn last
};

}  // namespace ps::gui
