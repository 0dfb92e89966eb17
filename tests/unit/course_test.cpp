#include "engine/course.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/check.h"
#include "engine/lesson.h"
#include "support/refusal.h"

namespace course_test {
namespace {
using namespace ps;

const std::vector<std::string> folders{"first", "second", "third"};

TEST(Course, IsReadWithItsPartsAndPrerequisites) {
  const Course course = parse_course("# A course\n\nSome words.\n\n## Start\n\n- second\n\n## More\n- first, after "
                                     "second\n- third, after second, first",
                                     "course.md", folders);
  EXPECT_EQ(course.title, "A course");
  ASSERT_EQ(course.parts.size(), 2u);
  EXPECT_EQ(course.parts[1].title, "More");
  EXPECT_EQ(course.parts[1].lessons[1].after, (std::vector<std::string>{"second", "first"}));
  EXPECT_TRUE(course.parts[0].lessons[0].after.empty());
  EXPECT_EQ(lessons_of(course), (std::vector<std::string>{"second", "first", "third"}));
  EXPECT_EQ(part_title(course, "third"), "More");
  EXPECT_EQ(part_title(course, "fourth"), "");
}

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { parse_course(text, "course.md", folders); });
}

TEST(Course, FaultsAreNamedWithTheirLine) {
  const std::string start = "# A course\n## Start\n- first\n";
  EXPECT_EQ(refusal(start), "");
  EXPECT_EQ(refusal(start + "- secont"),
            "course.md:4:1: found 'secont', which is not a lesson, expected a folder with a "
            "lesson.md; did you mean 'second'?");
  EXPECT_EQ(refusal(start + "- first"), "course.md:4:1: found 'first' a second time, expected each lesson once");
  EXPECT_EQ(refusal(start + "- second, after third"),
            "course.md:4:1: found after 'third', which is not before it, expected an earlier lesson");
  EXPECT_EQ(refusal(start + "- second, after second"),
            "course.md:4:1: found after 'second', which is not before it, expected an earlier lesson");
  EXPECT_EQ(refusal(start + "second"),
            "course.md:4:1: found 'second', expected '- lesson' or '- lesson, after lesson'");
  EXPECT_EQ(refusal(start + "# Another"), "course.md:4:1: found a second title, expected one line '# Title'");
  EXPECT_NE(refusal("## Start\n- first").find("no title"), std::string::npos);
  EXPECT_NE(refusal("# A course\n## Start\n").find("no lessons"), std::string::npos);
}

TEST(Course, EarlierNamesLeadOn) {
  const Course course =
      parse_course("# A course\n## Start\n- first\n- second\n\n## Earlier names\n\n- zeroth, now first\n"
                   "- half, now second/3\n",
                   "course.md", folders);
  EXPECT_EQ(course.parts.size(), 1u);
  EXPECT_EQ(lessons_of(course), (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(successor_in(course, {"zeroth", 4}), (LessonPlace{"first", 4}));
  EXPECT_EQ(successor_in(course, {"half", 1}), (LessonPlace{"second", 3}));  // the step behind its third
  EXPECT_EQ(successor_in(course, {"first", 0}), std::nullopt);
  EXPECT_EQ(successor_in(course, {"", 0}), std::nullopt);
  const std::string start = "# A course\n## Start\n- first\n## Earlier names\n";
  EXPECT_EQ(refusal(start), "");
  EXPECT_EQ(refusal(start + "- zeroth"), "course.md:5:1: found '- zeroth', expected '- earlier name, now lesson/STEP'");
  EXPECT_EQ(refusal(start + "- zeroth, now firsd").substr(0, 48), "course.md:5:1: found 'firsd', which is not a les");
  EXPECT_EQ(refusal(start + "- zeroth, now first/0").substr(0, 33), "course.md:5: found the step '0', ");
  EXPECT_EQ(refusal(start + "- second, now first"),
            "course.md:5:1: found 'second', which is a lesson, expected a name that no lesson has any more");
  EXPECT_EQ(refusal(start + "- zeroth, now first\n- zeroth, now first"),
            "course.md:6:1: found 'zeroth', which is there twice, expected a name that no lesson has any more");
}

TEST(Course, EarlierNamesLeadToSteps) {
  for (const EarlierName& each : load_course().earlier) {
    SCOPED_TRACE(each.name);
    EXPECT_LT(each.now.step, static_cast<int>(load_lesson(each.now.lesson).steps.size()));
    EXPECT_EQ(parse_lesson_place(each.name + "/2").lesson, each.now.lesson);
  }
}

// This program has no hardware renderer.
TEST(Course, ALessonAboutARendererThatIsNotThereIsLeftOut) {
  ASSERT_EQ(lessons_left_out().size(), 1u);
  EXPECT_EQ(lessons_left_out().front().name, "cgpp_15_7_the_hardware_pipeline");
  EXPECT_EQ(lessons_left_out().front().renderer, "hardware");
  EXPECT_EQ(test::refusal_of([&] { load_lesson("cgpp_15_7_the_hardware_pipeline/2"); }),
            "the lesson 'cgpp_15_7_the_hardware_pipeline' needs the renderer 'hardware', which this "
            "program was built without");
  EXPECT_TRUE(test::refusal_of([] {
                parse_lesson("# A\nsource: b\nrenderer: none\n", "own", "own.md");
              }).starts_with("own.md:3: "));
}

TEST(Course, HasEachLessonExactlyOnce) {
  std::vector<std::string> listed = lessons_of(load_course());
  std::vector<std::string> here = listed;
  for (const LeftOutLesson& each : lessons_left_out()) std::erase(here, each.name);
  EXPECT_EQ(here, lesson_names());
  std::sort(listed.begin(), listed.end());
  std::vector<std::string> present = lesson_folders();
  std::sort(present.begin(), present.end());
  EXPECT_EQ(listed, present) << "chapters/course.md and the folders with a lesson.md";
}

}  // namespace
}  // namespace course_test
