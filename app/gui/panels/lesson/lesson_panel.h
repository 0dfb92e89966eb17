#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "engine/lesson.h"
#include "gui/base/seen.h"
#include "gui/panels/lesson/glossary_sheet.h"
#include "gui/panels/lesson/lesson_claims.h"
#include "gui/panels/lesson/notes_sheet.h"
#include "gui/panels/lesson/text_view.h"
#include "gui/session/session.h"
#include "gui/work/file_watch.h"

namespace ps::gui {

/// What is said of the answer to the step's question.
struct StepVerdict {
  std::string question, sentence;
  std::optional<double> points;  ///< nothing for a question that was skipped
};

/// Which page of a step's text is shown, in its panel or as the presenter's caption.
struct ReadPage {
  int page = 0, pages = 1;
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
inline constexpr const char* read_lessons_key = "app/read-lessons";
/// From lines of a name each.
std::set<std::string> parse_read_lessons(const std::string& lines);

/// The lesson that the document names, read when it is first needed, and again when its file is saved.
class LessonShelf {
 public:
  /// `wake` may be called from any thread.
  explicit LessonShelf(std::function<void()> wake) : claims(wake), wake_(std::move(wake)) {}

  /// The open lesson, or nullptr. What cannot be read becomes a message of the session, once.
  const Lesson* open(Session& session);
  /// Once per frame: reads the open lesson anew if its file was saved since, and shows the step again. With an error in
  /// the file, which becomes a message, the lesson stays as it was.
  void update(Session& session);
  /// Grows each time a lesson is read. What follows from open() is up to date while this is the same.
  int version() const { return version_; }
  LessonClaims claims;  ///< of the open step
  ReadPage text, caption;
  LessonColumn column;
  bool holds_back = false;             ///< a question is open: hints and claims come after its answer
  std::optional<StepVerdict> verdict;  ///< it was answered
  bool turn_to_verdict = false;        ///< the page with it is to be shown, once
  bool ask_again = false;              ///< was clicked, until the question takes it
  bool blank = false;                  ///< the presenter's window is black, so that all look at the speaker
  ReadLessons read;
  GlossaryState glossary;
  NotesState notes;
  std::string shown_option;            ///< the page with its controls is to be turned to, once
  std::optional<LinkTarget> followed;  ///< what was clicked in the text, until the window takes it

 private:
  void load(Session& session);

  std::function<void()> wake_;
  std::string name_;
  std::optional<Lesson> lesson_;
  int version_ = 0;
  std::unique_ptr<FileWatch> watch_;  // since a lesson was first opened
};

/// The other one of the two is shown.
void turn_column(LessonColumn& column);

/// Puts a step on the screen: its scene, settings, channels and pixel. One step of the history.
void go_to_step(Session& session, const std::string& lesson, int step);
/// One step on or back in the open lesson; at its ends nothing happens.
void move_step(Session& session, LessonShelf& shelf, int by);
/// Once per frame: a new step, the verdict on an answer and an option that is pointed at are looked at in the text, a
/// tool that was chosen is shown.
void follow_column(const Session& session, LessonShelf& shelf);
/// One page on or back in the step's text, as it is shown; behind the last one the next step begins, before the first
/// one the previous step. A tool in the text's place comes behind the last page.
void read_lesson(Session& session, LessonShelf& shelf, int by);
/// The lesson before or after the open one, from its first step; the first lesson if none is open.
void move_lesson(Session& session, int by);
void close_lesson(Session& session);
/// Notes that a page was shown: with the last one of its last step a lesson is read to the end.
void note_read(LessonShelf& shelf, const Lesson& lesson, int step, const ReadPage& page);

/// The step's text with its controls, page by page, and the buttons to move on.
void lesson_panel(Session& session, LessonShelf& shelf);

}  // namespace ps::gui
