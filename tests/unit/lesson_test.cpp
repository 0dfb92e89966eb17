#include "engine/lesson.h"

#include <gtest/gtest.h>

#include "document/permalink.h"
#include "engine/claim.h"
#include "engine/lesson_length.h"
#include "support/lesson_demands.h"
#include "support/refusal.h"

namespace ps::lesson_test {
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
  ASSERT_EQ(lesson.blocks.size(), 1u);
  EXPECT_EQ(plain_text(lesson.blocks[0]), "First line second line.");
  ASSERT_EQ(lesson.steps.size(), 2u);
  const LessonStep& one = lesson.steps[0];
  EXPECT_EQ(one.title, "One");
  ASSERT_EQ(one.hints.size(), 2u);
  EXPECT_EQ(plain_text(one.hints[0]), "Look here, and here.");
  EXPECT_EQ(plain_text(one.hints[1]), "Look there.");
  EXPECT_EQ(one.state.scene, "cgfs/shadows");
  EXPECT_EQ(one.state.set_a, (std::vector<std::string>{"self-hit=epsilon", "shadow-epsilon=0"}));
  EXPECT_EQ(one.state.set_b, (std::vector<std::string>{"self-hit=epsilon", "renderer=rasterizer"}));
  const Document shown = state_document(one.state, Document{});
  EXPECT_EQ(shown.pixel, Vec2i(3, 4));
  EXPECT_EQ(Vec2i(shown.view.width, shown.view.height), Vec2i(60, 50));
  EXPECT_EQ(shown.b.show, ShownChannel::depth);
  EXPECT_EQ(shown.compare, CompareMode::split);
  EXPECT_EQ(shown.picked, Side::b);
}

TEST(Lesson, StepsStartFromTheCommonBlockAlone) {
  const Lesson lesson = parse_lesson(good, "demo", "lesson.md");
  EXPECT_EQ(lesson.steps[1].state.set_a, std::vector<std::string>{"self-hit=epsilon"});
  EXPECT_TRUE(lesson.steps[1].state.parts.empty());
}

TEST(Lesson, ClaimsAddToTheirStep) {
  const Lesson lesson = parse_lesson(good, "demo", "lesson.md");
  const Claim& claim = lesson.steps[0].claims.at(0);
  EXPECT_EQ(claim.text, "It differs.");
  EXPECT_EQ(metric_text(claim.metric), "differing-pixels");
  EXPECT_EQ(bound_text(claim.bound), ">= 1000");
  EXPECT_EQ(claim.mutation.text, "default shadow-epsilon");
  EXPECT_EQ(claim.mutation.reset, std::vector<std::string>{"shadow-epsilon"});
  EXPECT_EQ(claim.state.set_a.back(), "shadows=none");
  EXPECT_EQ(lesson.steps[0].state.set_a.back(), "shadow-epsilon=0");
  EXPECT_EQ(metric_text(lesson.steps[1].claims.at(0).metric), "counter-b shadow-rays");
}

TEST(Lesson, AStepChoosesASweepOrAnExperimentAndItsStage) {
  const auto state_with = [](const std::string& line) {
    std::string text = good;
    text.replace(text.find("pixel 3,4"), 9, line);
    return parse_lesson(text, "demo", "lesson.md").steps[0].state;
  };
  const LessonState chart = state_with("sweep shading=phong,flat;textures");
  EXPECT_EQ(chart.stage, "chart");
  EXPECT_EQ(*part_of(chart, "sweep"), "shading=phong,flat;textures=off,on");
  EXPECT_EQ(*part_of(state_with("sweep reflection-depths"), "sweep"), "reflection-depths");
  const LessonState laboratory = state_with("experiment bvh-holes");
  EXPECT_EQ(laboratory.stage, "stability");
  EXPECT_EQ(*part_of(laboratory, "experiment"), "bvh-holes");
  EXPECT_EQ(part_of(state_with("stage chart"), "sweep"), nullptr);
}

TEST(Lesson, AStepChoosesItsModeAndItsStage) {
  const auto document_of = [](const std::string& lines, ScreenMode now) {
    std::string text = good;
    text.replace(text.find("pixel 3,4"), 9, lines);
    Document document;
    document.mode = now;
    document.layout.bottom = 0;
    return lesson_document(parse_lesson(text, "demo", "lesson.md"), 0, document);
  };
  EXPECT_EQ(document_of("pixel 3,4", ScreenMode::explore).mode, ScreenMode::lesson);
  EXPECT_EQ(document_of("pixel 3,4", ScreenMode::explore).layout.stage, "");
  EXPECT_EQ(document_of("mode study", ScreenMode::lesson).mode, ScreenMode::study);
  EXPECT_EQ(document_of("mode explore", ScreenMode::presenter).mode, ScreenMode::presenter);
  const Document listing = document_of("stage listing", ScreenMode::lesson);
  EXPECT_EQ(listing.layout.stage, "listing");
  EXPECT_EQ(listing.layout.bottom_tab, "listing");
  EXPECT_GT(listing.layout.bottom, 0);
  EXPECT_EQ(document_of("stage story", ScreenMode::lesson).layout.stage, "story");
  const Document alone = document_of("stage pictures", ScreenMode::lesson);
  EXPECT_EQ(alone.layout.stage, pictures_stage);
  EXPECT_EQ(alone.layout.bottom_tab, Layout{}.bottom_tab);
  EXPECT_EQ(alone.layout.bottom, 0);
}

/// The document of the first step with these lines more in its settings.
Document document_with(const std::string& lines, const Document& now = {}) {
  std::string text = good;
  text.replace(text.find("pixel 3,4"), 9, "pixel 3,4\n" + lines);
  return lesson_document(parse_lesson(text, "demo", "lesson.md"), 0, now);
}

TEST(Lesson, AStepSetsWhatAPermalinkCan) {
  const Document document = document_with(R"(camera 1,2,-3,1,0,0,0,1,0,0,0,1,1,1,1
edit light.1.position (5, 6, 7)
zoom 8
middle 0.25,0.75
region 1,2,20,10
gain 16
event 3
other-event 4
vertex 2,5
look top
split 0.3
filled bottom
pin 7,8
pin.a.shadows none
a.threads 1)");
  // The permalink shows all of it again, under the same names.
  const std::string link = permalink(document);
  for (const char* part : {"camera=1,2,-3,1,0,0,0,1,0,0,0,1,1,1,1", "zoom=8", "middle=0.25,0.75", "region=1,2,20,10",
                           "gain=16", "&event=3", "other-event=4", "vertex=2,5", "look=top", "split=0.3",
                           "filled=bottom", "pin=7,8", "pin.a.shadows=none", "a.threads=1", "edit.light.1.position="})
    EXPECT_NE(link.find(part), std::string::npos) << part << " in " << link;
  EXPECT_EQ(document.scene.lights->at(1).position, Vec3d(5, 6, 7));
}

TEST(Lesson, ALinkLeadsToAStep) {
  EXPECT_EQ(parse_lesson_place("cgfs_03_light"), (LessonPlace{"cgfs_03_light", 0}));
  EXPECT_EQ(parse_lesson_place("cgfs_03_light/4"), (LessonPlace{"cgfs_03_light", 3}));
  for (const char* wrong : {"cgfs_03_ligt", "cgfs_03_light/0", "cgfs_03_light/", "cgfs_03_light/2x", ""})
    EXPECT_THROW(parse_lesson_place(wrong), InputError) << wrong;
  const Document linked = linked_document("lesson=cgfs_03_light&step=3");
  const Document reached = lesson_document(load_lesson("cgfs_03_light"), 3, Document{});
  EXPECT_EQ(permalink(linked), permalink(reached));
  EXPECT_THROW(linked_document("lesson=cgfs_03_ligt"), InputError);
  EXPECT_THROW(linked_document("step=3"), InputError);
}

TEST(Lesson, AStepCannotSayWhereItStands) {
  EXPECT_THROW(document_with("step 3"), InputError);
  EXPECT_THROW(document_with("lesson cgfs_03_light"), InputError);
  EXPECT_THROW(document_with("gain many"), InputError);
  EXPECT_THROW(document_with("edit light.1.position"), InputError);
  EXPECT_THROW(document_with("edit light.9.position (1, 2, 3)"), InputError);
}

TEST(Lesson, APanelThatAStepFillsDoesNotStayFilled) {
  std::string text = good;
  text.replace(text.find("pixel 3,4"), 9, "filled bottom");
  const Lesson lesson = parse_lesson(text, "demo", "lesson.md");
  Document document = lesson_document(lesson, 0, Document{});
  EXPECT_EQ(document.layout.filled, "bottom");
  EXPECT_EQ(lesson_document(lesson, 1, document).layout.filled, "");
  document = lesson_document(lesson, 1, document);
  document.layout.filled = "right";  // by hand
  EXPECT_EQ(lesson_document(lesson, 0, document).layout.filled, "bottom");
  EXPECT_EQ(lesson_document(lesson, 1, document).layout.filled, "right");
}

TEST(Lesson, TextIsNamedWithItsPlaceInTheFile) {
  const auto error_with = [](const std::string& words) -> std::string {
    std::string text = good;
    text.replace(text.find("Text of one."), 12, words);
    return test::refusal_of([&] { parse_lesson(text, "demo", "lesson.md"); });
  };
  EXPECT_EQ(error_with("Text of **one.").substr(0, 17), "lesson.md:14:9: f");
  EXPECT_EQ(error_with("Text of [one](step:3)."), "lesson.md:14:9: found a link to step 3, expected steps 1 to 2");
  EXPECT_EQ(error_with("Text of [one](step:2)."), "");
}

TEST(Lesson, NotesAreApartFromTheText) {
  std::string text = good;
  text.replace(text.find("```settings"), 0, "```notes\nAbout the *whole*.\n\n- a list\n```\n\n");
  text.replace(text.find("Text of one."), 12, "Text.\n\n```notes\nAbout [two](step:2).\n```\n");
  const Lesson lesson = parse_lesson(text, "demo", "lesson.md");
  ASSERT_EQ(lesson.notes.size(), 2u);
  EXPECT_EQ(plain_text(lesson.notes[0]), "About the whole.");
  EXPECT_EQ(lesson.notes[1].kind, BlockKind::bullet);
  ASSERT_EQ(lesson.blocks.size(), 1u);
  EXPECT_EQ(plain_text(lesson.blocks[0]), "First line second line.");
  ASSERT_EQ(lesson.steps[0].notes.size(), 1u);
  EXPECT_EQ(plain_text(lesson.steps[0].notes[0]), "About two.");
  ASSERT_EQ(lesson.steps[0].blocks.size(), 1u);
  EXPECT_EQ(plain_text(lesson.steps[0].blocks[0]), "Text.");
  EXPECT_TRUE(lesson.steps[1].notes.empty());
}

/// The lesson with `from` replaced must be refused with a message that holds `message`.
void expect_refused(const std::string& from, const std::string& to, const std::string& message) {
  std::string text = good;
  const auto at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  EXPECT_NE(test::refusal_of([&] { parse_lesson(text, "demo", "lesson.md"); }).find(message), std::string::npos);
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
  expect_refused("compare split", "mode presenter", "lesson.md:27: mode: found 'presenter'");
  expect_refused("compare split", "stage chrat", "lesson.md:27: stage: found 'chrat', expected 'chart'");
  expect_refused("picked b", "picked c", "lesson.md:28");
  expect_refused("metric differing-pixels", "metric pixels", "lesson.md:33: 'pixels' is not a metric");
  expect_refused("bound >= 1000", "bound > 1000", "lesson.md:34");
  expect_refused("bound >= 1000", "bound >= many", "lesson.md:34");
  expect_refused("bound >= 1000", "", "text, metric, bound and mutation");
  expect_refused("mutation shadow-epsilon", "mutation nothing", "lesson.md:36: mutation: 'nothing' is not an option");
  expect_refused("counter-b shadow-rays", "counter-b shadows", "'shadows' is not a counter");
  expect_refused("```claim", "```clam", "lesson.md:31:1");
  const std::string note = "```notes\nOne.\n```\n";
  expect_refused("Text of one.", note + note, "lesson.md:17:1: found a second block of notes");
  expect_refused("Text of one.", "```notes\n```", "lesson.md:14:1: found notes without words");
  expect_refused("Text of one.", "```notes\nOne.\n\n> Look.\n```", "lesson.md:14:1: found a hint in notes");
  expect_refused("Text of one.", "```notes\nOne.\nA **word.\n```", "lesson.md:16:3");
  expect_refused("Text of one.", "```notes\nSee [it](step:5).\n```", "lesson.md:15:5: found a link to step 5");
  expect_refused("mutation shadows\n```\n", "mutation shadows\n", "does not end");
}

/// As Windows' Notepad saves it.
TEST(Lesson, AByteOrderMarkIsNoText) {
  EXPECT_EQ(parse_lesson("\xEF\xBB\xBF# Marked\nsource: s\n\n## One\n\n```settings\nscene cgfs/spheres\n```\n", "own",
                         "own.md")
                .title,
            "Marked");
}

TEST(Lesson, WhatIsNoUtf8IsNamedWithItsPlace) {
  EXPECT_NE(test::refusal_of([&] {
              parse_lesson("# T\nsource: s\n\n## One\n\nA caf\xe9.\n", "own", "own.md");
            }).find("own.md:6:6: found the byte 0xe9"),
            std::string::npos);
}

TEST(Lesson, AStepHasAThousandFormulasAtMost) {
  const auto step_with = [](int formulas) {
    std::string text = "# T\nsource: s\n\n## One\n\n";
    for (int i = 0; i < formulas; ++i) text += "$x$ is it.\n";
    return text + "\n```settings\nscene cgfs/spheres\n```\n";
  };
  EXPECT_NO_THROW(parse_lesson(step_with(1000), "own", "own.md"));
  EXPECT_THROW(parse_lesson(step_with(1001), "own", "own.md"), InputError);
}

TEST(Lesson, BoundsAreInclusive) {
  EXPECT_TRUE(parse_bound(">= 2").holds(2));
  EXPECT_FALSE(parse_bound(">= 2").holds(1.5));
  EXPECT_TRUE(parse_bound("<= 2").holds(2));
  EXPECT_FALSE(parse_bound("<= 2").holds(2.5));
  EXPECT_TRUE(parse_bound("= 2").holds(2));
  EXPECT_FALSE(parse_bound("= 2").holds(2.001));
  EXPECT_TRUE(parse_bound("= 2 +- 0.5").holds(1.5));
  EXPECT_FALSE(parse_bound("= 2 +- 0.5").holds(1.4));
  EXPECT_EQ(bound_text(parse_bound("= 2 +- 0.5")), "= 2 +- 0.5");
  for (const char* wrong : {"2", "> 2", ">=", ">= 2 +- 1", "= 2 +-", "= 2 +- -1", "= 2 3"})
    EXPECT_THROW(parse_bound(wrong), InputError) << wrong;
}

TEST(Lessons, EveryFolderIsReadAndHasWhatALessonNeeds) {
  ASSERT_FALSE(lesson_names().empty());
  for (const std::string& name : lesson_names()) test::expect_complete(load_lesson(name));
}

TEST(LessonLength, FollowsFromWhatIsInIt) {
  LessonLength length{.words = 300, .steps = 4, .claims = 3, .questions = 1};
  EXPECT_EQ(length.minutes(), 6);  // 2 of reading, 2 of looking, 2 of trying
  length.words = 301;
  EXPECT_EQ(length.minutes(), 7) << "what has begun counts";
  EXPECT_EQ(length_text({.words = 30, .steps = 1, .claims = 0, .questions = 1}),
            "about 2 minutes: 30 words at 150 a minute, 1 step and 1 thing to try at half a minute each");
  const Lesson lesson = parse_lesson(good, "lesson", "lesson.md");
  const LessonLength counted = length_of(lesson);
  EXPECT_EQ(counted.steps, static_cast<int>(lesson.steps.size()));
  EXPECT_GT(counted.words, 10);
  EXPECT_LT(counted.words, 60);
}

TEST(Lessons, UnknownNamesNameTheNearest) {
  EXPECT_EQ(test::refusal_of([] { load_lesson("cgfs_14_texture"); }),
            "unknown lesson 'cgfs_14_texture'; did you mean 'cgfs_14_textures'?");
}

}  // namespace
}  // namespace ps::lesson_test
