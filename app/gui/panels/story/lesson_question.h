#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "engine/question.h"
#include "gui/session/session.h"
#include "gui/work/background_study.h"

namespace ps::gui {

/// The question of the open step, its measured answer, and what was answered so far.
class LessonQuestions {
 public:
  /// `wake` may be called from any thread. `remember`: answers are kept from one start to the next.
  LessonQuestions(const std::function<void()>& wake, bool remember);

  /// Takes up the open step's question, once for each step. Answers whether it is another one than before.
  bool follow(Session& session);
  /// The question of the open step; nullptr while it asks none, and where lessons are not read.
  const LessonQuestion* question() const { return question_ ? &*question_ : nullptr; }
  /// Whether it is still to be answered.
  bool open() const { return question_ && !verdict(); }
  /// The verdict on this step's answer; nullptr before it was given.
  const Judgement* verdict() const;
  /// Keeps what was answered.
  void take(Session& session, const std::string& answer, const Judgement& judgement);
  /// The step's question is asked anew.
  void ask_again() { answered_.erase(here_); }

  /// The right answer, once it is measured.
  std::shared_ptr<const MeasuredAnswer> right() const { return measuring_.found(); }
  /// Why it could not be measured.
  std::string failure() const { return measuring_.message(); }
  StudentAnswer answer;
  Vec2i pixel_before{-1, -1};  ///< that the step picks: a click moves it

 private:
  std::string here_;  // "name/2"
  std::optional<LessonQuestion> question_;
  std::map<std::string, Judgement> answered_;  // by step
  bool remember_ = false;
  BackgroundStudy<MeasuredAnswer> measuring_;
};

/// Asks a question that is not about the picked pixel's story, with controls for the answer.
void ask_lesson_question(Session& session, LessonQuestions& questions);

/// The verdict on the answer, with a button to be asked again.
void lesson_verdict(LessonQuestions& questions);

}  // namespace ps::gui
