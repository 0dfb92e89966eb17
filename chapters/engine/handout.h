#pragma once
#include <string>
#include <vector>

#include "base/progress.h"
#include "engine/lesson.h"

/// Lessons as pages to print or to read without the program.

namespace ps {

enum class HandoutFor {
  student,  ///< with the questions, and without the pictures that answer them
  teacher   ///< with the notes for teachers, and the measured answers at the end
};

/// The lesson as one HTML file that needs nothing else: texts, the pictures of A and B of each step, claims with what
/// was measured just now, questions, and a permalink for each step. It is well-formed XML as well. Throws InputError
/// where a step cannot be shown, and Cancelled.
std::string handout_html(const Lesson& lesson, HandoutFor reader, Progress& progress);

/// A page that leads to the handouts of these lessons, which lie beside it as NAME.html.
std::string handout_index(const std::vector<Lesson>& lessons);

/// A text of a lesson as HTML; formulas and links are written here alone.
std::string block_html(const std::vector<TextBlock>& blocks);

}  // namespace ps
