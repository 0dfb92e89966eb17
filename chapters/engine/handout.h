#pragma once
#include <string>
#include <vector>

#include "base/progress.h"
#include "engine/course.h"
#include "engine/lesson.h"

/// Lessons as pages to print or to read without the program.

namespace ps {

enum class HandoutFor {
  student,  ///< with room for answers, and without pictures and measurements that give them
  teacher   ///< with a plan of the time, and a page for each step: notes, what was measured, the answers, right and
            ///< wrong, and what comes next
};

/// The lesson as one HTML file for A4 that needs nothing else: goals, texts without keys and clicks, the pictures of A
/// and B of each step, questions, and the terms that it uses. It is well-formed XML as well. Throws InputError where a
/// step cannot be shown, and Cancelled.
std::string handout_html(const Lesson& lesson, HandoutFor reader, Progress& progress);

/// A page that leads to the handouts of these lessons, which lie beside it as NAME.html: the parts of the course, with
/// the lessons that each builds on, its minutes and its goals, and plans for classes of 45 and 90 minutes. Lessons that
/// are not in the course come last.
std::string handout_index(const Course& course, const std::vector<Lesson>& lessons);

/// A text of a lesson as HTML; formulas and links are written here alone.
std::string block_html(const std::vector<TextBlock>& blocks);
/// The same as a list with a line for each block; empty for none.
std::string list_html(std::vector<TextBlock> lines);

}  // namespace ps
