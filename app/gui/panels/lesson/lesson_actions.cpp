#include "gui/panels/lesson/lesson_actions.h"

#include <utility>

namespace ps::gui {
void add_lesson_actions(Actions& actions, Session& session, LessonShelf& shelf) {
  const auto in_lesson = [&session] { return !session.document().lesson.empty(); };
  const auto add = [&](const char* name, const char* label, const char* keys, std::function<void()> run,
                       std::function<bool()> enabled) {
    actions.add({.name = name,
                 .label = label,
                 .group = "Lesson",
                 .keys = keys,
                 .run = std::move(run),
                 .enabled = std::move(enabled)});
  };
  add(
      "step-next", "Next step", "Enter Shift+PageDown", [&session, &shelf] { move_step(session, shelf, 1); },
      in_lesson);
  add(
      "step-before", "Previous step", "Shift+PageUp", [&session, &shelf] { move_step(session, shelf, -1); }, in_lesson);
  add(
      "lesson-read-on", "Read on, then the next step", "PageDown",
      [&session, &shelf] { read_lesson(session, shelf, 1); }, in_lesson);
  add(
      "lesson-read-back", "Read back, then the previous step", "PageUp",
      [&session, &shelf] { read_lesson(session, shelf, -1); }, in_lesson);
  actions.add({.name = "text-or-tool",
               .label = "The step's text or its tool, where they share a place",
               .group = "Lesson",
               .keys = "V",
               .run = [&shelf] { turn_column(shelf.column); },
               .enabled = [&shelf] { return shelf.column.shared; }});
  actions.add({.name = "blank",
               .label = "Blank the presenter's screen",
               .group = "Lesson",
               .keys = "B",
               .borrowed_keys = ".",
               .run = [&shelf] { shelf.blank = !shelf.blank; },
               .enabled = [&session] { return session.document().mode == ScreenMode::presenter; },
               .checked = [&shelf] { return shelf.blank; }});
  add("lesson-after", "Next lesson", "]", [&session] { move_lesson(session, 1); }, {});
  add("lesson-before", "Previous lesson", "[", [&session] { move_lesson(session, -1); }, {});
  add("glossary", "Glossary: terms and what they mean", "Shift+G", [&shelf] { open_glossary(shelf.glossary); }, {});
  add(
      "notes", "Notes for the teacher on this step", "Shift+T", [&shelf] { toggle_notes(shelf.notes); }, in_lesson);
  add(
      "lesson-close", "Close the lesson", "", [&session] { close_lesson(session); }, in_lesson);
}

}  // namespace ps::gui
