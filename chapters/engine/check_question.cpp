#include <fmt/format.h>

#include <cmath>

#include "engine/bug_question.h"
#include "engine/measured_pictures.h"
#include "engine/metric_words.h"
#include "engine/question.h"
#include "render/render.h"

namespace ps {
namespace {

/// The largest share of the pictures that may be right for a click: more can be hit blindly.
constexpr double most_of_places = 0.5;

int right_choice(const LessonQuestion& question, double value) {
  for (std::size_t i = 0; i < question.choices.size(); ++i)
    if (question.choices[i].bound.holds(value)) return static_cast<int>(i);
  return -1;
}

std::string ending(const std::string& sentence) { return sentence.empty() ? "" : " " + sentence; }

std::string with_unit(double value, const std::string& unit) {
  return measured_text(value) + (unit.empty() ? "" : " " + unit);
}

/// The fault of the choices; empty if there is none.
std::string check_choices(const LessonQuestion& question, double value) {
  int right = 0;
  for (const AnswerChoice& choice : question.choices) {
    if (choice.bound.holds(value))
      ++right;
    else if (choice.feedback.empty())
      return fmt::format("the wrong choice '{}' has no sentence", choice.text);
  }
  if (right == 1) return {};
  return fmt::format("{} choices are right", right == 0 ? "no" : "several");
}

std::string check_places(const Image<unsigned char>& places, std::string& found) {
  double right = 0;
  for (const unsigned char place : places.pixels()) right += place;
  const double share = right / static_cast<double>(places.pixels().size());
  found = fmt::format("{} of {} pixels", right, places.pixels().size());
  if (right == 0) return "no pixel is right";
  return share > most_of_places ? "more than half of the pixels are right" : "";
}

std::string check_pixel(const LessonQuestion& question, Progress& progress, std::string& found) {
  const Document document = state_document(question.state, Document{});
  if (document.pixel.x < 0) return "no pixel is picked";
  Prepared prepared;
  const PixelStory story = inspect(document.scene, view_of(document), side_of(document, document.picked).settings,
                                   document.pixel, prepared, progress);
  if (const auto objection = not_askable(question.about, story)) return std::string(*objection);
  found = right_answer_text(question.about, story, document.scene);
  return {};
}

}  // namespace

MeasuredAnswer measure_answer(const LessonQuestion& question, Progress& progress, MeasuredPictures* pictures) {
  if (question.kind == AskKind::bug) return find_bug(question);
  const Document document = state_document(question.state, pictures ? pictures->last() : Document{});
  MeasuredAnswer answer;
  if (question.kind == AskKind::click)
    answer.places = places_within(question.metric, question.bound, document, progress, pictures);
  else
    answer.value = measure(question.metric, document, progress, pictures);
  return answer;
}

Judgement judge(const LessonQuestion& question, const StudentAnswer& answer, const MeasuredAnswer& right) {
  switch (question.kind) {
  case AskKind::choice: {
    const int wanted = right_choice(question, right.value);
    if (answer.choice < 0 || wanted < 0) return {};
    const AnswerChoice& given = question.choices.at(static_cast<std::size_t>(answer.choice));
    if (answer.choice == wanted) return {1, "Right." + ending(given.feedback) + ending(question.why)};
    const AnswerChoice& correct = question.choices.at(static_cast<std::size_t>(wanted));
    return {0, fmt::format("{} Right is: {}{}", given.feedback, correct.text, ending(question.why))};
  }
  case AskKind::number: {
    const bool good = std::abs(answer.number - right.value) <= question.tolerance;
    return {good ? 1.0 : 0.0,
            good ? fmt::format("Right: {}.{}", with_unit(right.value, question.unit), ending(question.why))
                 : fmt::format("It is {}; you said {}.{}", with_unit(right.value, question.unit),
                               with_unit(answer.number, question.unit), ending(question.why))};
  }
  case AskKind::click: {
    const Vec2i at = answer.place;
    const bool good = right.places.contains(at.x, at.y) && right.places.at(at.x, at.y) != 0;
    return {good ? 1.0 : 0.0,
            (good ? "Right." : fmt::format("Pixel ({}, {}) is not such a place.", at.x, at.y)) + ending(question.why)};
  }
  case AskKind::bug:
    return judge_line(question, answer.line, right);
  case AskKind::pixel:
    break;
  }
  return {};
}

std::string right_sentence(const LessonQuestion& question, const MeasuredAnswer& right) {
  switch (question.kind) {
  case AskKind::choice: {
    const int wanted = right_choice(question, right.value);
    if (wanted < 0) return {};
    const AnswerChoice& choice = question.choices.at(static_cast<std::size_t>(wanted));
    return fmt::format("Right is: {}{}{}", choice.text, ending(choice.feedback), ending(question.why));
  }
  case AskKind::number:
    return fmt::format("It is {}.{}", with_unit(right.value, question.unit), ending(question.why));
  case AskKind::click:
    for (int y = 0; y < right.places.height(); ++y)
      for (int x = 0; x < right.places.width(); ++x)
        if (right.places.at(x, y) != 0)
          return fmt::format("Pixel ({}, {}) is such a place.{}", x, y, ending(question.why));
    break;
  case AskKind::bug:
    return fmt::format("The bug is in line {}.{}", right.line.number, ending(question.why));
  case AskKind::pixel:
    break;
  }
  return {};
}

std::string right_sentence(const LessonQuestion& question, const PixelStory& story, const Scene& scene) {
  if (not_askable(question.about, story)) return {};
  return fmt::format("{}.{}", right_answer_text(question.about, story, scene), ending(question.why));
}

std::string check_question(const LessonQuestion& question, Progress& progress, std::string& found,
                           MeasuredPictures* pictures) {
  if (question.kind == AskKind::bug) return check_bug(question, progress, found);
  if (question.kind == AskKind::pixel) return check_pixel(question, progress, found);
  const MeasuredAnswer answer = measure_answer(question, progress, pictures);
  if (question.kind == AskKind::click) return check_places(answer.places, found);
  found = with_unit(answer.value, question.unit);
  if (question.kind == AskKind::choice) {
    found += fmt::format(", choice {} of {}", right_choice(question, answer.value) + 1, question.choices.size());
    return check_choices(question, answer.value);
  }
  return std::isfinite(answer.value) ? "" : "the answer is not a finite number";
}

}  // namespace ps
