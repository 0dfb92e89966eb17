#include "engine/course.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/check.h"
#include "engine/lesson.h"

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
  try {
    parse_course(text, "course.md", folders);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Course, FaultsAreNamedWithTheirLine) {
  const std::string start = "# A course\n## Start\n- first\n";
  EXPECT_EQ(refusal(start), "accepted");
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

TEST(Course, HasEachLessonExactlyOnce) {
  std::vector<std::string> listed = lessons_of(load_course());
  EXPECT_EQ(listed, lesson_names());
  std::sort(listed.begin(), listed.end());
  std::vector<std::string> present = lesson_folders();
  std::sort(present.begin(), present.end());
  EXPECT_EQ(listed, present) << "chapters/course.md and the folders with a lesson.md";
}

}  // namespace
}  // namespace course_test
