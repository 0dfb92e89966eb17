#include "gui/frame/menu_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/enumerators.h"
#include "document/permalink.h"
#include "gui/frame/show_panel.h"
#include "gui/input/key_hint.h"
#include "gui/panels/lesson/first_look.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/panels/pictures/picture_size.h"
#include "gui/widgets/draw.h"

namespace ps::gui {

void MenuBar::view_menu() {
  if (!begin_menu("menu/view", "View")) return;
  const auto items = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) menu_action(actions_, name, MenuLabel::name);
    ImGui::Separator();
  };
  // What has a key or a button in sight, and what is set once, has menus of its own: this one fits a screen of 768
  // lines at type 1.5 too.
  const auto below = [&](const char* menu, const char* label, std::initializer_list<const char*> names) {
    if (!begin_menu(menu, label)) return;
    for (const char* name : names) menu_action(actions_, name, MenuLabel::name);
    end_menu();
  };
  items({"undo", "redo", "history", "kept"});
  items({"side-by-side", "split", "difference", "only-a", "only-b"});
  below("menu/zoom", "Zoom", {"fit", "one-to-one", "zoom-in", "zoom-out"});
  below("menu/pictures", "In the pictures", {"grid", "handles", "gizmo", "channel-next", "channel-before"});
  if (begin_menu("menu/size", "Picture size")) {
    for (const char* name : {"size-own", "size-half", "size-double", "size-shown"}) menu_action(actions_, name);
    size_fields(session_);
    end_menu();
  }
  below("menu/window", "Window", {"panels", "fullscreen"});
  ImGui::Separator();
  items({"slow-motion", "predict"});
  menu_action(actions_, "reset-view", MenuLabel::name);
  menu_action(actions_, "fly");
  tooltip(fmt::format("{}, {} and so on turn the camera; {}, {} and so on move it around the scene.",
                      actions_.key_text("turn-left"), actions_.key_text("turn-up"), actions_.key_text("orbit-left"),
                      actions_.key_text("orbit-up")));
  ImGui::Separator();
  below("menu/type", "Theme and type", {"dark-theme", "larger-type", "smaller-type", "standard-type"});
  end_menu();
}

void MenuBar::study_menu() {
  if (!begin_menu("menu/study", "Tools")) return;
  for (const Panel& panel : panels_) {
    if (panel.facts.place != PanelPlace::below) continue;
    if (panel.facts.name == "chart") ImGui::Separator();  // what follows is about the whole picture
    menu_action(actions_, "study-" + std::string(panel.facts.name));
  }
  end_menu();
}

/// Modes, and all that is not needed in the first minutes.
void MenuBar::main_menu() {
  if (!begin_menu("menu", "Menu")) return;
  for (const char* name : {"mode-lesson", "mode-explore", "mode-study", "mode-presenter"})
    menu_action(actions_, name, MenuLabel::name);
  ImGui::Separator();
  view_menu();
  study_menu();
  help_menu();
  ImGui::Separator();
  menu_action(actions_, "quit");
  end_menu();
}

void MenuBar::help_menu() {
  if (!begin_menu("menu/help", "Help")) return;
  if (menu_item("first-look", "A first look", {}, session_.document().lesson == first_look_lesson))
    go_to_step(session_, first_look_lesson, 0);
  for (const char* name : {"help", "palette"}) menu_action(actions_, name);
  ImGui::Separator();
  if (menu_item("about", "About Pixelscope")) about_.show();
  end_menu();
}

/// A button of the bar that runs an action, with its key in the tooltip.
void MenuBar::bar_button(std::string_view action, std::string_view label) {
  const Action* found = actions_.find(action);
  const bool enabled = !found->enabled || found->enabled();
  if (button("bar/" + std::string(action), label, Emphasis::quiet,
             {.tooltip = with_key(found->label, action), .disabled = enabled ? "" : "There is no step to go to."}))
    found->run();
}

void MenuBar::draw() {
  if (!ImGui::BeginMenuBar()) return;
  ImGui::SetCursorPosX(px(8));
  main_menu();
  scene_menu();
  lesson_menu();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + px(8));
  const std::string search = fmt::format("Search {}", actions_.key_text("palette"));
  const float right = compare_buttons_width() + button_width(search) + button_width("?") + px(16);
  const float left = ImGui::GetWindowWidth() - right;
  // Where large type leaves them no room they are in menus and on their keys.
  if (ImGui::GetCursorPosX() + button_width("Undo") + button_width("Redo") + px(24) < left) {
    bar_button("undo", "Undo");
    bar_button("redo", "Redo");
  }
  if (ImGui::GetCursorPosX() < left) {
    compare_buttons(left);
    bar_button("palette", search);
    bar_button("help", "?");
  } else if (const float few = ImGui::GetWindowWidth() - compare_buttons_width(); ImGui::GetCursorPosX() < few) {
    compare_buttons(few);
  }
  ImGui::EndMenuBar();
}

namespace {
struct Mode {
  CompareMode mode;
  const char *label, *help;
};
constexpr std::array modes{
    Mode{CompareMode::side_by_side, "A | B", "Both pictures side by side."},
    Mode{CompareMode::split, "Split", "One picture: A on the left of a divider that you drag, B on the right."},
    Mode{CompareMode::difference, "Difference", "The difference B - A, multiplied by a gain."}};
}  // namespace

float MenuBar::compare_buttons_width() const {
  float width = px(12);
  for (const auto& mode : modes) width += button_width(mode.label) + ImGui::GetStyle().ItemSpacing.x;
  return width + px(12);
}

/// How the pictures are arranged, always in sight: it is what the window is about.
void MenuBar::compare_buttons(float left) {
  ImGui::SetCursorPosX(left);
  const NameScope scope("compare");
  const CompareMode wanted = session_.document().compare;
  for (const auto& mode : modes)
    if (button_on_off(enumerator_key(mode.mode), mode.label, shown_ == mode.mode,
                      {.tooltip = mode.mode == wanted && shown_ != wanted
                                      ? "Both pictures side by side: two have no room here that one does not fill "
                                        "better, so they are shown as a split."
                                      : with_key(mode.help, enumerator_key(mode.mode))}))
      session_.navigate([&](Document& document) { document.compare = mode.mode; });
}

}  // namespace ps::gui
