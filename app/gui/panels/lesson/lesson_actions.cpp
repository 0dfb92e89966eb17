#include "gui/panels/lesson/lesson_panel.h"

namespace ps::gui {

void LessonPanel::add_actions(Actions& actions) {
  ActionGroup open(actions, "Lesson", [this] { return !session_.document().lesson.empty(); });
  open.add("step-next", "Next step", "Enter Shift+PageDown", [this] { move_step(session_, state, 1); });
  open.add("step-before", "Previous step", "Shift+PageUp", [this] { move_step(session_, state, -1); });
  open.add("lesson-read-on", "Read on, then the next step", "PageDown", [this] { read_lesson(session_, state, 1); });
  open.add("lesson-read-back", "Read back, then the previous step", "PageUp",
           [this] { read_lesson(session_, state, -1); });
  ActionGroup(actions, "Lesson", [this] {
    return state.column.shared;
  }).add("text-or-tool", "The step's text or its tool, where they share a place", "V", [this] {
    turn_column(state.column);
  });
  actions.add({.name = "blank",
               .label = "Blank the presenter's screen",
               .group = "Lesson",
               .keys = "B",
               .borrowed_keys = ".",
               .run = [this] { state.blank = !state.blank; },
               .enabled = [this] { return session_.document().mode == ScreenMode::presenter; },
               .checked = [this] { return state.blank; }});
  ActionGroup any(actions, "Lesson");
  any.add("lesson-after", "Next lesson", "]", [this] { move_lesson(session_, 1); });
  any.add("lesson-before", "Previous lesson", "[", [this] { move_lesson(session_, -1); });
  open.add("lesson-close", "Close the lesson", "", [this] { close_lesson(session_); });
}

}  // namespace ps::gui
