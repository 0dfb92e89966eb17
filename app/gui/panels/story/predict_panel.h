#pragma once
#include <optional>
#include <string>

#include "gui/panels/lesson/lesson_question.h"
#include "inspect/predict.h"

namespace ps::gui {

/// Predict before reveal: the question, the answer and the score.
struct PredictState {
  /// `questions`: those of the open lesson; must outlive it.
  explicit PredictState(LessonQuestions& questions) : lesson(&questions) {}

  bool on = false;  ///< every newly picked pixel is asked about; a lesson's step may ask all the same
  Question question = Question::colour;
  Guess guess;
  bool chosen = false;        ///< an answer was picked from the list, where there is one
  Vec2i asked_pixel{-1, -1};  ///< that the question is about
  Settings asked_settings;    ///< of the side whose story is shown, then
  bool answered = false;      ///< without meaning for a lesson's question: LessonQuestions keeps what was answered
  Judgement judgement;
  int asked = 0;  ///< questions answered so far
  double points = 0;
  std::string words;  ///< of the lesson's question about the pixel; empty = none
  LessonQuestions* lesson;
};

/// Whether an open question hides the story. Takes up the lesson's question, and a newly picked pixel. Questions of a
/// lesson that are not about the picked pixel's story hide it too, while they are asked beside the text.
bool prediction_pending(Session& session, PredictState& state);

/// From now on every picked pixel is asked about, beginning with the one that is. Opens the panel that asks, wherever
/// the window has no place for the question: one that is not visible does not hide.
void ask_about_pixels(Session& session, PredictState& state);

/// Whether the open question is about the picked pixel, whose surroundings answer it.
bool asks_about_pixel(const Session& session, const PredictState& state);

/// Asks, with a control for the answer.
void predict_panel(Session& session, PredictState& state);

/// Stands where the story would answer an open question of a lesson.
inline constexpr const char* story_after_answer = "The story is shown after your answer to the step's question.";

/// The verdict on the last answer with the score, above the story. Not drawn while none was asked.
void prediction_verdict(Session& session, PredictState& state);

}  // namespace ps::gui
