// The unchanged copy of each listing, compiled by the system's compiler and run as a child process, gives the listing's
// own picture and values to the bit; a changed line gives others.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/lesson.h"
#include "student/check_listing.h"
#include "support/own_listings.h"
#include "support/trials.h"

namespace ps::listing_copies_test {
namespace {
using test::OwnListings;

/// The first step of the lesson in which its listing makes a picture, or the first of all.
Document small_document(const NamedListing& listing) {
  const Lesson lesson = load_lesson(listing.folder);
  Document document = lesson_document(lesson, 0, Document{});
  for (int step = 1; step < static_cast<int>(lesson.steps.size()); ++step) {
    if (document.a.settings.renderer == Renderer::textbook) break;
    Document next = lesson_document(lesson, step, Document{});
    if (next.a.settings.renderer != Renderer::textbook) continue;
    next.a.settings.listing_bug = 0;
    document = std::move(next);
  }
  document.view.width = 240;
  document.view.height = 180;
  return document;
}

class ListingCopies : public testing::TestWithParam<std::size_t> {};

TEST_P(ListingCopies, GiveTheSameBits) {
  const NamedListing& listing = listings()[GetParam()];
  OwnListings own;
  const Compilation compiled = compile_listing(own.permits().copy(listing));
  for (const CompilerMessage& message : compiled.messages) ADD_FAILURE() << message.line << ": " << message.text;
  ASSERT_TRUE(compiled.program) << compiled.failure;
  const Document document = small_document(listing);
  const View view = view_of(document);
  const Vec2i pixel{130, 80};
  Progress progress;
  const CheckedListing checked =
      check_listing(*compiled.program, listing, document.scene, view, document.a.settings, pixel, progress);
  ASSERT_EQ(checked.run.failure, "") << checked.run.text;
  EXPECT_EQ(checked.wrong.count, 0u) << verdict_text(checked.wrong, view.width, view.height);

  const ListingTrace right = trace_listing(document.scene, view, settings_of_listing(listing, document.a.settings),
                                           pixel, nullptr, TracedTriangles::all);
  const OwnTrace& trace = *checked.run.result.trace;
  ASSERT_EQ(trace.watches.size(), right.watches.size());
  for (std::size_t i = 0; i < right.watches.size(); ++i) {
    EXPECT_EQ(trace.watches[i].name, right.watches[i].name);
    EXPECT_EQ(watch_text(trace.watches[i].value), watch_text(right.watches[i].value));
    EXPECT_EQ(trace.watches[i].instance, right.watches[i].instance);
  }
  EXPECT_EQ(trace.instances.size(), right.instances.size());

  bool background_alone = true;
  for (const Vec3d& colour : checked.right.pixels())
    background_alone = background_alone && colour == checked.right.at(0, 0);
  EXPECT_FALSE(background_alone) << "the scene shows something";
}

/// What the lesson asks to be written compiles before it is, and does not draw what it should. Where others need what
/// it gives, there may be no picture: then the message says what is missing.
TEST_P(ListingCopies, WhatIsToBeWrittenCompilesAndIsToBeDone) {
  const NamedListing& listing = listings()[GetParam()];
  const Lesson lesson = load_lesson(listing.folder);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const std::string& routine = lesson.steps[i].write;
    if (routine.empty()) continue;
    OwnListings own;
    const Compilation compiled = compile_listing(own.permits().copy(listing, routine));
    ASSERT_TRUE(compiled.program) << routine << ": " << compiled.failure;
    const Document document = lesson_document(lesson, static_cast<int>(i), Document{});
    Progress progress;
    const CheckedListing checked =
        check_listing(*compiled.program, listing, document.scene, view_of(document), document.a.settings, {}, progress);
    if (routine == "interpolate") {
      EXPECT_EQ(checked.run.failure,
                "It threw an exception: an entry was asked for that a list of 0 values does not have");
      continue;
    }
    ASSERT_EQ(checked.run.failure, "") << routine;
    EXPECT_GT(checked.wrong.count, 0u) << routine;
  }
}

// Nearly all of their time is the system's compiler's, which a sanitizer does not see.
INSTANTIATE_TEST_SUITE_P(All, ListingCopies, testing::Range(std::size_t{0}, listings().size(), test::list_step),
                         [](const auto& index) { return listings()[index.param].folder; });

/// A step that asks for a routine says in three bullets how to test it.
TEST(ListingCopy, LessonsAskForRoutinesWithThreeTests) {
  int tasks = 0;
  for (const std::string& name : lesson_names())
    for (const LessonStep& step : load_lesson(name).steps) {
      if (step.write.empty()) continue;
      ++tasks;
      const auto bullets = std::count_if(step.blocks.begin(), step.blocks.end(),
                                         [](const TextBlock& block) { return block.kind == BlockKind::bullet; });
      EXPECT_EQ(bullets, 3) << name << ", " << step.title;
    }
  EXPECT_GE(tasks, 15);
}

TEST(ListingCopy, ATaskOfALessonIsReadWithItsErrors) {
  const auto fault = [](const std::string& name, const std::string& block) -> std::string {
    try {
      const std::string start = "# T\nsource: s\n\n## One\n\n```settings\nscene cgfs/spheres\n```\n\n";
      return parse_lesson(start + "```task\n" + block + "```\n", name, "lesson.md").steps.at(0).write;
    } catch (const InputError& error) {
      return error.what();
    }
  };
  const std::string lines = "cgfs_06_lines";
  EXPECT_EQ(fault(lines, "write draw_line\n"), "draw_line");
  EXPECT_EQ(fault(lines, "write nothing\n"),
            "lesson.md:11:7: found the routine 'nothing', expected one of the listing: interpolate, draw_line, draw");
  EXPECT_EQ(fault(lines, "read draw_line\n"), "lesson.md:11:1: found 'read', expected a line 'write ROUTINE'");
  EXPECT_EQ(fault(lines, ""), "lesson.md:10:1: found a task without words, expected a line 'write ROUTINE'");
  EXPECT_EQ(
      fault("cgfs_05_glass", "write draw\n"),
      "lesson.md:10:1: found a task in a lesson without a listing of the program, expected tasks in the program's own "
      "lessons alone: a listing.cpp in another folder is not compiled");
}

TEST(ListingCopy, AChangedLineIsFoundAtItsFirstPixel) {
  const NamedListing& listing = test::listing_in("cgfs_02_basic_ray_tracing");
  OwnListings own;
  const Compilation compiled = own.compile(
      test::with_change(listing_copy(listing), "  return closest_sphere->colour;\n",
                        "  return closest_sphere->name == \"red\" ? Vec3d(1, 2, 3) : closest_sphere->colour;\n"));
  ASSERT_TRUE(compiled.program) << compiled.failure;
  const Document document = small_document(listing);
  const View view = view_of(document);
  Progress progress;
  const CheckedListing checked =
      check_listing(*compiled.program, listing, document.scene, view, document.a.settings, {}, progress);
  ASSERT_EQ(checked.run.failure, "");
  Vec2i first{-1, -1};
  std::size_t red = 0;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
      if (checked.right.at(x, y) == Vec3d(255, 0, 0) && red++ == 0) first = {x, y};
  EXPECT_GT(red, 100u);
  EXPECT_EQ(checked.wrong.count, red);
  EXPECT_EQ(checked.wrong.first, first);
  EXPECT_EQ(checked.wrong.own, Vec3d(1, 2, 3));
  EXPECT_EQ(checked.wrong.right, Vec3d(255, 0, 0));
}

}  // namespace
}  // namespace ps::listing_copies_test
