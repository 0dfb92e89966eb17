#pragma once
#include <optional>
#include <string>

#include "engine/lesson.h"
#include "gui/session/session.h"

namespace ps::gui {

/// How much of a step's text lesson_panel() showed last, in pixels.
struct LessonText {
  float above = 0, below = 0;  ///< scrolled out of sight
  float page = 1;              ///< what one page turns
  int frame = -2;              ///< when that was
  int turn = 0;                ///< pages still to be turned, on or back
  std::string lesson;
  int step = 0;
};

/// Which page of the step the presenter's strip shows.
struct CaptionState {
  int page = 0, pages = 1;
  bool turned_back = false;  ///< the previous step was reached from its end
  bool blank = false;        ///< the window is black, so that all look at the speaker
  std::string lesson;
  int step = 0;
};

/// In how many pages the step's text is read; 1 where all of it is in sight.
int pages_of(const LessonText& text);

/// The lesson that the document names, read when it is first needed.
class LessonShelf {
 public:
  /// The open lesson, or nullptr. What cannot be read becomes a message of the session, once.
  const Lesson* open(Session& session);
  LessonText text;
  CaptionState caption;

 private:
  std::string name_;
  std::optional<Lesson> lesson_;
};

/// Puts a step on the screen: its scene, settings, channels and pixel. One step of the history.
void go_to_step(Session& session, const std::string& lesson, int step);
/// One step on or back in the open lesson; at its ends nothing happens.
void move_step(Session& session, LessonShelf& shelf, int by);
/// One page on or back in the step's text; one step, where the rest of the text is in sight.
void read_lesson(Session& session, LessonShelf& shelf, int by);
/// The lesson before or after the open one, from its first step; the first lesson if none is open.
void move_lesson(Session& session, int by);
void close_lesson(Session& session);

/// Title, step n of m, text, hints, and the buttons to move on.
void lesson_panel(Session& session, LessonShelf& shelf);

}  // namespace ps::gui
