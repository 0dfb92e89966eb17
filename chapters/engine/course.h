#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson.h"

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

/// A name that a lesson had before, so that links with it lead on.
struct EarlierName {
  std::string name;
  LessonPlace now;  ///< where its first step is now; the others follow
};

struct Course {
  std::string title;
  std::vector<CoursePart> parts;
  std::vector<EarlierName> earlier;
};

/// Reads the course: "# Title", a line "## Part" before the lessons of each part, and for each lesson "- name" or
/// "- name, after name, name". Lines "- name, now name" or "- name, now name/STEP" (STEP from 1) below "## Earlier
/// names" say where lessons are that had another name. All before the first part is text for those who read the file.
/// Throws InputError with file and line for a name that is not in `folders`, one that is there twice, a lesson that
/// builds on a later one, an earlier name that a lesson has, and any other line.
Course parse_course(std::string_view text, const std::string& file, const std::vector<std::string>& folders);

/// The course of chapters/course.md, read anew. Throws InputError as parse_course() does, and if it cannot be read.
Course load_course();

/// Names of all its lessons, in order.
std::vector<std::string> lessons_of(const Course& course);

/// Where a step is now of a lesson that once had the name `place.lesson`; nullopt for any other name.
std::optional<LessonPlace> successor_in(const Course& course, const LessonPlace& place);
/// The same in load_course(); nullopt if that cannot be read.
std::optional<LessonPlace> successor_of(const LessonPlace& place);

/// Title of the part with this lesson; empty if none has it.
std::string_view part_title(const Course& course, std::string_view lesson);

}  // namespace ps
