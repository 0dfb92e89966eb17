#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/lesson.h"

/// Where lessons are: those that the program comes with have names, one's own are folders anywhere. What
/// parse_lesson_place() and load_lesson() take as a name may also be the path of such a folder, with "/STEP" behind it.

namespace ps {

/// Is it the name of a lesson that this program comes with and can show?
bool is_built_in(std::string_view name);

/// As parse_lesson_place(), for the lessons that the program comes with alone: links in texts lead to these.
LessonPlace parse_built_in_place(std::string_view text);
/// A step's number as people count, from 1; from 0 in the result. Throws InputError for anything else.
int parse_step_number(std::string_view text);

/// The folder of the lesson that a path names, itself or by its lesson.md, as an absolute path; empty if there is none.
std::string lesson_folder_at(const std::filesystem::path& path);
/// Whether a Lesson::name is somebody's own folder.
bool is_own_lesson(std::string_view name);

}  // namespace ps
