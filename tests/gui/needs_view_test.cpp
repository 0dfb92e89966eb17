// The advice in words: work is not time, and what the clock cannot distinguish is not shown.
#include "gui/panels/studies/needs_view.h"

#include <gtest/gtest.h>

namespace ps::gui::needs_view_test {
namespace {

Needs needs_with(double time, double default_time, bool differs) {
  Needs needs;
  needs.advice.shadows = Shadows::none;
  needs.work = 60'000;
  needs.default_work = 1'000'000;
  needs.tolerance = 0.05;
  needs.time_ms = time;
  needs.default_time_ms = default_time;
  needs.time_differs = differs;
  return needs;
}

TEST(NeedsAdvice, SaysWhatWorkIs) {
  const NeedsAdvice words = needs_advice(needs_with(10, 20, true), Settings{});
  EXPECT_NE(words.verdict.find("94 % of the counted work"), std::string::npos) << words.verdict;
  EXPECT_NE(words.verdict.find("allowed: 0.05, hard to see"), std::string::npos) << words.verdict;
  EXPECT_EQ(words.changes, "shadows=none");
  EXPECT_EQ(words.words, "without shadows");
  EXPECT_NE(words.saving.find("60,000 instead of 1 M rays, tests, fragments and reads of textures and maps"),
            std::string::npos)
      << words.saving;
  EXPECT_EQ(words.time, "Here the time is less, too: 10 ms instead of 20 ms.");
}

TEST(NeedsAdvice, SaysThatLessWorkWasNotLessTime) {
  const auto time = [](const Needs& needs) { return needs_advice(needs, Settings{}).time; };
  EXPECT_TRUE(time(needs_with(26.88, 18.19, true)).starts_with("Less work, but not less time here"));
  for (const Needs& needs : {needs_with(26, 18, false), needs_with(10, 18, false)})
    EXPECT_NE(time(needs).find("within noise"), std::string::npos) << time(needs);
}

}  // namespace
}  // namespace ps::gui::needs_view_test
