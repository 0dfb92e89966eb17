// Questions for the wrong line of a listing: that the line is found by comparing the files, how a click on a line is
// judged, and what makes such a question a bad one.
#include "engine/bug_question.h"

#include <gtest/gtest.h>

#include "engine/handout.h"
#include "engine/lesson.h"
#include "support/refusal.h"
#include "support/run_cli.h"

namespace ps::bug_question_test {
namespace {

const std::string sides = "set-both renderer=textbook\nset listing-bug=sunken-spheres\n";
const std::string asks = "ask bug\ntext Which line?\nwhy The root is missing.\n";

Lesson lesson_with(const std::string& settings, const std::string& question) {
  return parse_lesson("# T\nsource: s\n\n## One\n\n```settings\nscene cgfs/spheres\nsize 120x120\n" + settings +
                          "```\n\n```question\n" + question + "```\n",
                      "demo", "lesson.md");
}

LessonQuestion question_with(const std::string& settings) {
  return lesson_with(settings, asks).steps.at(0).question.value();
}

std::string objection(const std::string& settings) {
  Progress progress;
  std::string found;
  return check_question(question_with(settings), progress, found);
}

std::string fault_of(const std::string& question) {
  return test::refusal_of([&] { lesson_with(sides, question); });
}

TEST(BugQuestion, TheLineIsFoundAndClicksAreJudgedByIt) {
  const LessonQuestion question = question_with(sides + "pixel 40,118\n");
  EXPECT_EQ(ask_text(question), "bug");
  Progress progress;
  const MeasuredAnswer right = measure_answer(question, progress);
  EXPECT_EQ(right.bug, "sunken_spheres");
  EXPECT_EQ(right.line.number, 41);  // of listing.cpp, in which the sentence at the head of the variant is missing
  EXPECT_EQ(right.line.right, "  const double t2 = (-b - std::sqrt(discriminant)) / (2 * a);");
  EXPECT_EQ(judge(question, {.line = 41}, right).points, 1);
  EXPECT_EQ(judge(question, {.line = 41}, right).sentence, "Right. The root is missing.");
  for (const int wrong : {0, 40, 42}) EXPECT_EQ(judge(question, {.line = wrong}, right).points, 0);
  EXPECT_EQ(judge(question, {.line = 40}, right).sentence,
            "Line 40 is the same in both listings. The bug is in line 41. The root is missing.");
}

/// Of another bug another line is right.
TEST(BugQuestion, EachBugHasItsOwnLine) {
  Progress progress;
  const LessonQuestion question = question_with("set-both renderer=textbook\nset listing-bug=no-horizon\n");
  const MeasuredAnswer right = measure_answer(question, progress);
  EXPECT_EQ(right.line.number, 35);
  EXPECT_EQ(judge(question, {.line = 41}, right).points, 0);
}

TEST(BugQuestion, TheCheckFindsBadOnes) {
  EXPECT_EQ(objection(sides + "pixel 40,118\n"), "");
  EXPECT_EQ(objection(sides), "no pixel is picked");
  EXPECT_EQ(objection(sides + "pixel 60,20\n"), "the bug does not change the picked pixel");
  EXPECT_EQ(objection(sides + "pixel 40,118\npicked b\n"), "the picked pixel is one of B");
  EXPECT_EQ(objection("set-both renderer=textbook\npixel 40,118\n"), "A runs no listing with a bug");
  EXPECT_EQ(objection(sides + "set renderer=ray-tracer\npixel 40,118\n"), "A runs no listing with a bug");
  EXPECT_EQ(objection(sides + "set listing=cgfs-03-light\npixel 40,118\n"), "A runs no listing with a bug");
  EXPECT_EQ(objection(sides + "set-b renderer=ray-tracer\npixel 40,118\n"),
            "B is not the listing of A without its bug");
  EXPECT_EQ(objection(sides + "set-b listing-bug=no-horizon\npixel 40,118\n"),
            "B is not the listing of A without its bug");
  // Nothing in this scene reflects.
  EXPECT_EQ(objection("set-both renderer=textbook\nset-both listing=cgfs-04-shadows-and-reflections\n"
                      "set listing-bug=chrome\npixel 40,118\n"),
            "the bug changes no pixel");
}

TEST(BugQuestion, FaultsOfItsBlockAreNamed) {
  EXPECT_NE(fault_of("ask bug\ntext x\n").find("'ask bug' without a line 'why'"), std::string::npos);
  EXPECT_NE(fault_of(asks + "hide a\n").find("'ask bug' with a line 'hide'"), std::string::npos);
  EXPECT_NE(fault_of(asks + "metric red-a\n").find("'ask bug' with a line 'metric'"), std::string::npos);
}

TEST(BugQuestion, EveryBugHasAStep) {
  for (const NamedListing& listing : listings())
    EXPECT_EQ(bugs_without_step(load_lesson(listing.folder)), std::vector<std::string>{}) << listing.folder;
  Lesson lesson = load_lesson("cgfs_06_lines");
  std::erase_if(lesson.steps, [](const LessonStep& step) { return step.title == "Find the bug: dots"; });
  EXPECT_EQ(bugs_without_step(lesson), std::vector<std::string>{"dotted_lines"});
}

/// A student reads the whole function, the teacher also the answer.
TEST(BugQuestion, HandoutsHoldBackTheLine) {
  Progress progress;
  const Lesson lesson = lesson_with(sides + "pixel 40,118\n", asks);
  const std::string student = handout_html(lesson, HandoutFor::student, progress);
  EXPECT_NE(student.find("  29  Roots intersect_ray_sphere("), std::string::npos);
  EXPECT_NE(student.find("  41    const double t2 = (-b - discriminant) / (2 * a);"), std::string::npos);
  EXPECT_NE(student.find("  44  }"), std::string::npos);
  EXPECT_EQ(student.find("canvas_to_viewport"), std::string::npos);  // another function
  EXPECT_EQ(student.find("trace_ray"), std::string::npos);
  EXPECT_EQ(student.find("std::sqrt(discriminant)) / (2 * a);\n  42"), std::string::npos);
  EXPECT_EQ(student.find("The root is missing."), std::string::npos);
  const std::string teacher = handout_html(lesson, HandoutFor::teacher, progress);
  EXPECT_NE(teacher.find("Line 41. "), std::string::npos);
  EXPECT_NE(teacher.find("The root is missing."), std::string::npos);
}

}  // namespace
}  // namespace ps::bug_question_test
