#pragma once
#include <string>
#include <string_view>
#include <vector>

/// The course: chapters/course.md alone holds which lessons there are to read in which order.

namespace ps {

struct CourseLesson {
  std::string name;                ///< the folder
  std::vector<std::string> after;  ///< lessons that it builds on, all earlier in the course
};

struct CoursePart {
  std::string title;
  std::vector<CourseLesson> lessons;
};

struct Course {
  std::string title;
  std::vector<CoursePart> parts;
};

/// Reads the course: "# Title", a line "## Part" before the lessons of each part, and for each lesson "- name" or
/// "- name, after name, name". All before the first part is text for those who read the file. Throws InputError with
/// file and line for a name that is not in `folders`, one that is there twice, a lesson that builds on a later one, and
/// any other line.
Course parse_course(std::string_view text, const std::string& file, const std::vector<std::string>& folders);

/// The course of chapters/course.md, read anew. Throws InputError as parse_course() does, and if it cannot be read.
Course load_course();

/// Names of all its lessons, in order.
std::vector<std::string> lessons_of(const Course& course);

/// Title of the part with this lesson; empty if none has it.
std::string_view part_title(const Course& course, std::string_view lesson);

}  // namespace ps
