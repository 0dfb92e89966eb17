#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/metric.h"
#include "engine/state.h"
#include "image/image.h"
#include "inspect/predict.h"
#include "textbook/listing_source.h"

/// Questions of a lesson's step. The right answer is never written down: it is measured.

namespace ps {

enum class AskKind {
  choice,  ///< one of several sentences; right is the one whose bound the metric keeps
  number,  ///< the metric's value
  click,   ///< a pixel of the pictures at which the metric keeps the bound
  bug,     ///< the line of A's listing that is wrong
  pixel    ///< about the picked pixel, as core/inspect/predict.h asks
};

/// One of the sentences of AskKind::choice.
struct AnswerChoice {
  Bound bound;           ///< kept by the metric: this is the right one
  std::string text;      ///< the answer
  std::string feedback;  ///< what is wrong about it, or more about it if it is right
};

struct LessonQuestion {
  AskKind kind = AskKind::choice;
  std::string text;
  Question about = Question::colour;         ///< AskKind::pixel
  LessonState state;                         ///< in which it is measured: the step's, with the question's own lines
  Metric metric;                             ///< AskKind::choice, number and click
  std::vector<AnswerChoice> choices;         ///< AskKind::choice
  Bound bound;                               ///< AskKind::click
  double tolerance = 0;                      ///< AskKind::number: how far off an answer may be
  std::string unit;                          ///< AskKind::number
  std::string why;                           ///< said after the answer; may be empty, but for AskKind::bug
  std::array<bool, 2> hidden{false, false};  ///< the pictures of A and B that are covered until it is answered
};

/// "choice", "number", "click", "bug", "colour", "winner", "rays", "triangle", "tests"
std::string_view ask_text(const LessonQuestion& question);

/// The right answer to a question, but for AskKind::pixel.
struct MeasuredAnswer {
  double value = 0;             ///< of the metric; choice and number
  Image<unsigned char> places;  ///< click: 1 where the answer is right
  std::string bug;              ///< bug: its name, as ListingBug has it
  BugLine line;                 ///< bug: in which it differs from the listing
};

/// Measures the right answer. Throws InputError when it cannot be measured, and Cancelled. Not for AskKind::pixel.
/// `pictures`: what earlier measurements have rendered.
MeasuredAnswer measure_answer(const LessonQuestion& question, Progress& progress, MeasuredPictures* pictures = nullptr);

/// A student's answer; only the member of the question's kind counts.
struct StudentAnswer {
  int choice = -1;
  double number = 0;
  Vec2i place{-1, -1};
  int line = 0;  ///< of the listing, from 1
};

/// One point or none, and a sentence that says what is right.
Judgement judge(const LessonQuestion& question, const StudentAnswer& answer, const MeasuredAnswer& right);

/// The right answer and its reason, for somebody who gave none; for AskKind::pixel from the pixel's story.
std::string right_sentence(const LessonQuestion& question, const MeasuredAnswer& right);
std::string right_sentence(const LessonQuestion& question, const PixelStory& story, const Scene& scene);

/// Why a question is not a good one: no choice is right or several are, a wrong one has no sentence, every place is
/// right or none, the pixel's story does not answer it. Empty if it is one. `found` is set to the measured answer in
/// words.
std::string check_question(const LessonQuestion& question, Progress& progress, std::string& found,
                           MeasuredPictures* pictures = nullptr);

}  // namespace ps
