#include "support/lesson_demands.h"

#include <gtest/gtest.h>

#include <cctype>
#include <string>

#include "engine/lesson_length.h"
#include "engine/lesson_place.h"
#include "engine/state.h"

namespace ps::test {
namespace {

void expect_complete_step(const LessonStep& step) {
  EXPECT_FALSE(step.blocks.empty()) << "a step without text";
  EXPECT_FALSE(step.hints.empty()) << "a step without a hint";
  EXPECT_NO_THROW(state_document(step.state, Document{}));
  for (const auto* blocks : {&step.blocks, &step.hints})
    for (const TextBlock& block : *blocks)
      for (const TextSpan& span : block.spans)
        if (span.link.kind == LinkKind::lesson) {
          EXPECT_LT(span.link.step, std::ssize(load_lesson(span.link.target).steps)) << span.text;
        }
}

}  // namespace

void expect_complete(const Lesson& lesson) {
  SCOPED_TRACE(lesson.name);
  EXPECT_GE(lesson.steps.size(), 5u);
  EXPECT_EQ(lesson.goals.size(), 3u);
  for (const TextBlock& goal : lesson.goals) {
    const std::string words = plain_text(goal);
    EXPECT_TRUE(std::islower(static_cast<unsigned char>(words.front()))) << words;
    EXPECT_NE(words.back(), '.') << words;
  }
  std::size_t claims = 0;
  for (const LessonStep& step : lesson.steps) {
    SCOPED_TRACE(step.title);
    claims += step.claims.size();
    expect_complete_step(step);
  }
  EXPECT_GE(claims, 3u);
  const int minutes = length_of(lesson).minutes();
  EXPECT_GE(minutes, 3);
  EXPECT_LE(minutes, 30);
}

}  // namespace ps::test
