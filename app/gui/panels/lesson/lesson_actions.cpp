#include "gui/panels/lesson/lesson_actions.h"

#include <utility>

#include "gui/panels/lesson/caption_strip.h"

namespace ps::gui {
namespace {

/// The presenter's text is read page by page.
void step_by(Session& session, LessonShelf& shelf, int by) {
  if (session.document().mode == ScreenMode::presenter)
    turn_caption(session, shelf, by);
  else
    move_step(session, shelf, by);
}

}  // namespace

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
      "step-next", "Next step", "Enter PageDown", [&session, &shelf] { step_by(session, shelf, 1); }, in_lesson);
  add(
      "step-before", "Previous step", "PageUp", [&session, &shelf] { step_by(session, shelf, -1); }, in_lesson);
  add(
      "lesson-read-on", "Read on, then the next step", "Shift+PageDown",
      [&session, &shelf] { read_lesson(session, shelf, 1); }, in_lesson);
  add(
      "lesson-read-back", "Read back, then the previous step", "Shift+PageUp",
      [&session, &shelf] { read_lesson(session, shelf, -1); }, in_lesson);
  actions.add({.name = "blank",
               .label = "Blank the presenter's screen",
               .group = "Lesson",
               .keys = "B",
               .run = [&shelf] { shelf.caption.blank = !shelf.caption.blank; },
               .enabled = [&session] { return session.document().mode == ScreenMode::presenter; },
               .checked = [&shelf] { return shelf.caption.blank; }});
  add("lesson-after", "Next lesson", "]", [&session] { move_lesson(session, 1); }, {});
  add("lesson-before", "Previous lesson", "[", [&session] { move_lesson(session, -1); }, {});
  add(
      "lesson-close", "Close the lesson", "", [&session] { close_lesson(session); }, in_lesson);
}

}  // namespace ps::gui
