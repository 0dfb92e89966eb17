#include "engine/lesson_length.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace ps {
namespace {

int words_in(const std::vector<TextBlock>& blocks) {
  int count = 0;
  for (const TextBlock& block : blocks) {
    std::istringstream words(plain_text(block));
    for (std::string word; words >> word;) ++count;
  }
  return count;
}

const char* ending(int count) { return count == 1 ? "" : "s"; }

}  // namespace

int LessonLength::minutes() const {
  return static_cast<int>(
      std::ceil(words / words_a_minute + steps * minutes_a_step + (claims + questions) * minutes_a_trial));
}

LessonLength length_of(const Lesson& lesson) {
  LessonLength length;
  length.words = words_in(lesson.blocks);
  length.steps = static_cast<int>(lesson.steps.size());
  for (const LessonStep& step : lesson.steps) {
    length.words += words_in(step.blocks) + words_in(step.hints);
    length.claims += static_cast<int>(step.claims.size());
    length.questions += step.question ? 1 : 0;
  }
  return length;
}

std::string length_text(const LessonLength& length) {
  const int trials = length.claims + length.questions;
  return fmt::format(
      "about {} minute{}: {} words at {:g} a minute, {} step{} and {} thing{} to try at half a minute each",
      length.minutes(), ending(length.minutes()), length.words, LessonLength::words_a_minute, length.steps,
      ending(length.steps), trials, ending(trials));
}

}  // namespace ps
