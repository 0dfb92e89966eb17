#pragma once
#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "gui/base/seen.h"
#include "gui/panels/lesson/lesson_claims.h"
#include "gui/panels/lesson/lesson_question.h"
#include "gui/panels/lesson/lesson_shelf.h"
#include "gui/panels/panel.h"

namespace ps::gui {

/// Which page of a step's text is shown, in its panel or as the presenter's caption.
struct ReadPage {
  int page = 0, pages = 1;
  bool asks = false;         ///< the presenter asks the step's question on this page
  bool turned_back = false;  ///< the step was entered by paging back from the next one
  Seen seen;
  double line_length = 0;  ///< characters that a full line holds; of the panel's text alone
  std::string lesson;
  int step = 0;
};

/// Which of the two is shown where a step's text and its tool have one place.
enum class ColumnShows { text, tool };

/// That place. A new step shows its text first.
struct LessonColumn {
  ColumnShows shows = ColumnShows::text;
  bool shared = false;  ///< the window has one place for both, as it was drawn last
  std::string lesson, stage;
  int step = -1;
  std::uint64_t change = 0;  ///< of the session, like the step and its stage when they were looked at last
};

/// A new step begins on its first page, or on its last one where the page before was asked for.
void follow_step(const Session& session, ReadPage& read);

/// Which lessons were read to their end, kept from one start to the next.
struct ReadLessons {
  std::set<std::string> names;  ///< folders
  std::function<void(std::string lines)> remember;
};

/// The open lesson, and what is shown of its step. The document holds which step that is.
struct LessonReading {
  explicit LessonReading(const PanelHost& host);

  LessonShelf shelf;
  LessonClaims claims;
  LessonQuestions questions;
  ReadPage text, caption;
  LessonColumn column;
  ReadLessons read;
  // As the frame began: a page turns to a verdict once the question has left its place to the text.
  std::optional<StepVerdict> verdict;
  bool holds_back = false;
  bool blank = false;         ///< the presenter's window is black, so that all look at the speaker
  bool ask_again = false;     ///< was clicked, until the next frame
  std::function<void()> ask;  ///< draws the open question with its controls; empty while none is asked
  float ask_height = 200;     ///< that it took when it was drawn last, window pixels
  std::string asked;          ///< the question that ask_height is about
  std::string shown_option;   ///< the page with its controls is to be turned to, once
};

/// The other one of the two is shown.
void turn_column(LessonColumn& column);

/// One step on or back in the open lesson; at its ends nothing happens.
void move_step(Session& session, LessonReading& state, int by);
/// Once per frame: a new step, the verdict on an answer and an option that is pointed at are looked at in the text, a
/// tool that was chosen is shown.
void follow_column(const Session& session, LessonReading& state);
/// One page on or back in the step's text, as it is shown; behind the last one the next step begins, before the first
/// one the previous step. A tool in the text's place comes behind the last page.
void read_lesson(Session& session, LessonReading& state, int by);
/// Notes that a page was shown: with the last one of its last step a lesson is read to the end.
void note_read(LessonReading& state, const Lesson& lesson, int step, const ReadPage& page);

/// The step's text with its controls, page by page, and the buttons to move on.
class LessonPanel final : public Panel {
 public:
  explicit LessonPanel(const PanelHost& host);
  bool draw(const Context& context) override;
  void add_actions(Actions& actions) override;
  void offer(Values& out) override;
  void update() override;
  bool busy() const override { return state.questions.measuring(); }
  void take(const PanelMessage& message) override;

  LessonReading state;  ///< for the frame, which has places for text, tool, question and caption
};

}  // namespace ps::gui
