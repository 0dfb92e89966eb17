#include "engine/lesson.h"

#include <gtest/gtest.h>

#include "engine/claim.h"

namespace ps {
namespace lesson_test {
namespace {

constexpr const char* good = R"(# Light and shade
source: a book, chapter 4

First line
second line.

```settings
scene cgfs/shadows
set-both self-hit=epsilon
```

## One

Text of one.

> Look here,
> and here.

> Look there.

```settings
set shadow-epsilon=0
set-b renderer=rasterizer
pixel 3,4
size 60x50
show-b depth
compare split
picked b
```

```claim
text It differs.
metric differing-pixels
bound >= 1000
set shadows=none
mutation shadow-epsilon
```

## Two

```claim
text It counts.
metric counter-b shadow-rays
bound = 0
mutation shadows
```
)";

TEST(Lesson, ReadsTextStepsAndClaims) {
  const Lesson lesson = parse_lesson(good, "demo", "lesson.md");
  EXPECT_EQ(lesson.name, "demo");
  EXPECT_EQ(lesson.title, "Light and shade");
  EXPECT_EQ(lesson.source, "a book, chapter 4");
  EXPECT_EQ(lesson.paragraphs, std::vector<std::string>{"First line second line."});
  ASSERT_EQ(lesson.steps.size(), 2u);
  const LessonStep& one = lesson.steps[0];
  EXPECT_EQ(one.title, "One");
  EXPECT_EQ(one.hints, (std::vector<std::string>{"Look here, and here.", "Look there."}));
  EXPECT_EQ(one.state.scene, "cgfs/shadows");
  EXPECT_EQ(one.state.set_a, (std::vector<std::string>{"self-hit=epsilon", "shadow-epsilon=0"}));
  EXPECT_EQ(one.state.set_b, (std::vector<std::string>{"self-hit=epsilon", "renderer=rasterizer"}));
  EXPECT_EQ(*one.state.pixel, Vec2i(3, 4));
  EXPECT_EQ(*one.state.size, Vec2i(60, 50));
  EXPECT_EQ(one.state.show_b, ShownChannel::depth);
  EXPECT_EQ(one.state.compare, CompareMode::split);
  EXPECT_EQ(one.state.picked, Side::b);
}

TEST(Lesson, StepsStartFromTheCommonBlockAlone) {
  const Lesson lesson = parse_lesson(good, "demo", "lesson.md");
  EXPECT_EQ(lesson.steps[1].state.set_a, std::vector<std::string>{"self-hit=epsilon"});
  EXPECT_FALSE(lesson.steps[1].state.pixel);
}

TEST(Lesson, ClaimsAddToTheirStep) {
  const Lesson lesson = parse_lesson(good, "demo", "lesson.md");
  const Claim& claim = lesson.steps[0].claims.at(0);
  EXPECT_EQ(claim.text, "It differs.");
  EXPECT_EQ(claim.metric, ClaimMetric::differing_pixels);
  EXPECT_EQ(claim.bound, ClaimBound::at_least);
  EXPECT_EQ(claim.number, 1000);
  EXPECT_EQ(claim.mutation, "shadow-epsilon");
  EXPECT_EQ(claim.state.set_a.back(), "shadows=none");
  EXPECT_EQ(lesson.steps[0].state.set_a.back(), "shadow-epsilon=0");
  EXPECT_EQ(lesson.steps[1].claims.at(0).counter, Counter::shadow_rays);
  EXPECT_EQ(lesson.steps[1].claims.at(0).metric, ClaimMetric::counter_b);
}

TEST(Lesson, AStepChoosesASweepOrAnExperimentAndOpensItsTab) {
  const auto state_with = [](const std::string& line) {
    std::string text = good;
    text.replace(text.find("pixel 3,4"), 9, line);
    return parse_lesson(text, "demo", "lesson.md").steps[0].state;
  };
  const LessonState chart = state_with("sweep shading=phong,flat;textures");
  EXPECT_EQ(chart.tab, "chart");
  EXPECT_EQ(chart.sweep, "shading=phong,flat;textures=off,on");
  EXPECT_EQ(state_with("sweep reflection-depths").sweep, "reflection-depths");
  const LessonState laboratory = state_with("experiment bvh-holes");
  EXPECT_EQ(laboratory.tab, "stability");
  EXPECT_EQ(laboratory.experiment, "bvh-holes");
  EXPECT_EQ(state_with("tab chart").sweep, "");
}

/// The lesson with `from` replaced must be refused with a message that holds `message`.
void expect_refused(const std::string& from, const std::string& to, const std::string& message) {
  std::string text = good;
  const auto at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    parse_lesson(text, "demo", "lesson.md");
    ADD_FAILURE() << "accepted " << to;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(Lesson, FaultsAreNamedWithTheirLine) {
  expect_refused("# Light and shade", "Light and shade", "title");
  expect_refused("source:", "sauce:", "source");
  expect_refused("scene cgfs/shadows", "", "scene");
  expect_refused("set shadow-epsilon=0", "set shadow-epsilom=0", "lesson.md:22: unknown option 'shadow-epsilom'");
  expect_refused("pixel 3,4", "pixel 3", "lesson.md:24: pixel");
  expect_refused("pixel 3,4", "sweep reflections", "lesson.md:24: unknown option 'reflections'");
  expect_refused("pixel 3,4", "experiment bhv-holes", "lesson.md:24: unknown experiment 'bhv-holes'");
  expect_refused("size 60x50", "size 0x50", "lesson.md:25: picture size");
  expect_refused("show-b depth", "show-b dept", "lesson.md:26");
  expect_refused("compare split", "compare both", "lesson.md:27");
  expect_refused("picked b", "picked c", "lesson.md:28");
  expect_refused("metric differing-pixels", "metric pixels", "lesson.md:33: 'pixels' is not a metric");
  expect_refused("bound >= 1000", "bound > 1000", "lesson.md:34");
  expect_refused("bound >= 1000", "bound >= many", "lesson.md:34");
  expect_refused("bound >= 1000", "", "text, metric, bound and mutation");
  expect_refused("mutation shadow-epsilon", "mutation nothing", "lesson.md:36: mutation: 'nothing' is not an option");
  expect_refused("counter-b shadow-rays", "counter-b shadows", "'shadows' is not a counter");
  expect_refused("```claim", "```clam", "lesson.md:31:1");
  expect_refused("mutation shadows\n```\n", "mutation shadows\n", "does not end");
}

TEST(Lesson, BoundsAreInclusive) {
  Claim claim;
  claim.number = 2;
  EXPECT_TRUE(keeps_bound(claim, 2));
  EXPECT_FALSE(keeps_bound(claim, 1.5));
  claim.bound = ClaimBound::at_most;
  EXPECT_TRUE(keeps_bound(claim, 2));
  EXPECT_FALSE(keeps_bound(claim, 2.5));
  claim.bound = ClaimBound::equals;
  EXPECT_TRUE(keeps_bound(claim, 2));
  EXPECT_FALSE(keeps_bound(claim, 1));
}

TEST(Lessons, EveryFolderIsReadAndHasWhatALessonNeeds) {
  const auto names = lesson_names();
  ASSERT_FALSE(names.empty());
  for (const std::string& name : names) {
    const Lesson lesson = load_lesson(name);
    EXPECT_GE(lesson.steps.size(), 5u) << name;
    std::size_t claims = 0;
    for (const LessonStep& step : lesson.steps) {
      claims += step.claims.size();
      EXPECT_FALSE(step.paragraphs.empty()) << name << ": " << step.title;
      EXPECT_FALSE(step.hints.empty()) << name << ": " << step.title;
      EXPECT_NO_THROW(state_document(step.state, Document{})) << name << ": " << step.title;
    }
    EXPECT_GE(claims, 3u) << name;
  }
}

TEST(Lessons, UnknownNamesNameTheNearest) {
  try {
    load_lesson("cgfs_14_texture");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown lesson 'cgfs_14_texture'; did you mean 'cgfs_14_textures'?");
  }
}

}  // namespace
}  // namespace lesson_test
}  // namespace ps
