#pragma once
#include <imgui.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/question.h"
#include "gui/base/hand_clock.h"
#include "gui/panels/lesson/lesson_shelf.h"
#include "gui/work/background_study.h"

namespace ps::gui {

/// What is said of the answer to the step's question.
struct StepVerdict {
  std::string question, sentence;
  std::optional<double> points;  ///< nullopt for a question that was skipped
};

/// The question of the open step, its measured answer, and what was answered so far.
class LessonQuestions {
 public:
  /// `wake` may be called from any thread. `remember`: answers are kept from one start to the next. `shelf` must
  /// outlive it.
  LessonQuestions(const std::function<void()>& wake, bool remember, LessonShelf& shelf);

  /// Takes up the open step's question, once for each step and each time that the lesson was read. Answers whether it
  /// did.
  bool follow(Session& session);
  /// The question of the open step; nullptr while it asks none, and where lessons are not read.
  const LessonQuestion* question() const { return question_ ? &*question_ : nullptr; }
  /// Whether it is still to be answered.
  bool open() const { return question_ && !verdict(); }
  /// Whether it is, and is shown beside the lesson's text; the presenter's window has no place for it.
  bool asked_beside_text(const Session& session) const;
  /// Hints, claims and the pictures that it covers come after its answer, also where it is not asked: a projector is
  /// not to show what the audience is asked afterwards.
  bool holds_back() const { return open() && question_->kind != AskKind::bug; }
  /// The verdict on this step's answer; nullptr before it was given.
  const Judgement* verdict() const;
  /// The answer in words; empty for a question that was passed over.
  std::string given() const;
  /// Keeps what was answered.
  void take(Session& session, const std::string& answer, const Judgement& judgement);
  /// The step's question is taken up anew, as if it had not been answered.
  void ask_again();
  /// Once per frame: measures the right answer unless the processors are needed for something else.
  void hold(bool held);

  /// Whether the question asks for the wrong line of A's listing, and A runs that listing.
  bool bug_shown(const Session& session) const;
  /// The wrong line of A's listing, once a question for it was answered and as long as A runs that listing.
  std::optional<BugLine> bug_verdict(const Session& session) const;

  /// The right answer, once it is measured.
  std::shared_ptr<const MeasuredAnswer> right() const { return to_measure_ ? nullptr : measuring_.found(); }
  bool measuring() const { return to_measure_ || measuring_.running(); }
  /// Why it could not be measured.
  std::string failure() const { return to_measure_ ? "" : measuring_.message(); }
  /// Once per frame: to a question that was skipped, the right answer once it is known.
  void tell_skipped(const Session& session);
  FreshPlace place;              ///< what the text shows: a click right after a change does not count
  bool turn_to_verdict = false;  ///< the page with it is to be shown, once
  StudentAnswer answer;
  std::string typed;           ///< AskKind::number
  Vec2i pixel_before{-1, -1};  ///< that the step picks: a click moves it

 private:
  struct Answered {
    std::string words;
    Judgement judgement;
  };

  void read_answers(Session& session);

  LessonShelf& shelf_;
  std::string here_;  // "name/2"
  int version_ = -1;  // of the lesson
  std::optional<LessonQuestion> question_;
  std::map<std::string, Answered> answered_;  // by step
  bool remember_ = false, answers_read_ = false;
  bool to_measure_ = false;  // the right answer, once nothing holds it
  BackgroundStudy<MeasuredAnswer> measuring_;
};

/// Where a question is asked: beside the step's tool; below the text, where text and tool share a place; or, of a
/// question for a line of the listing, while the listing has that place, in one line: its buttons alone.
enum class AskPlace { beside_tool, below_text, in_line };

/// Asks a question that is not about the picked pixel's story, with controls for the answer. Answers whether the other
/// one of text and tool is asked for: a question for a line of the listing has a button for that.
bool ask_lesson_question(Session& session, LessonQuestions& questions, AskPlace place);

/// Where the open question is about another pixel, or other options, than are shown.
inline constexpr std::string_view why_question_waits =
    "The question is about the pixel and the options that the step begins with.";

/// Says so, with the button.
void way_back_to_question(Session& session, const LessonQuestions& questions);
/// The button alone, which leads back.
void way_back_button(Session& session);

/// A bar from `top` down to the end of the item that was drawn last, in the colour of right or of wrong.
void verdict_bar(ImVec2 top, const Judgement& judgement);

/// The right answer with its reason, to those who were not judged; what keeps one from it while it is not known.
std::string told_answer(const LessonQuestions& questions);

/// The verdict on the answer to the step's question, for the lesson's text; nullopt before that.
std::optional<StepVerdict> shown_verdict(const LessonQuestions& questions);

}  // namespace ps::gui
