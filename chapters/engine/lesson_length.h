#pragma once
#include <string>

#include "engine/lesson.h"

namespace ps {

/// How long a lesson takes, from what is in it.
struct LessonLength {
  int words = 0;  ///< of introduction, steps and hints
  int steps = 0;
  int claims = 0;  ///< measured sentences, each of which is something to try
  int questions = 0;

  /// Words at `words_a_minute`; `minutes_a_step` to look at the pictures of each step, and `minutes_a_trial` for each
  /// claim and each question. Rounded up.
  int minutes() const;
  static constexpr double words_a_minute = 150, minutes_a_step = 0.5, minutes_a_trial = 0.5;
};

LessonLength length_of(const Lesson& lesson);

/// "about 12 minutes: 900 words at 150 a minute, 7 steps and 5 things to try at half a minute each"
std::string length_text(const LessonLength& length);

}  // namespace ps
