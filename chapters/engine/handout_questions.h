#pragma once
#include <string>

#include "base/progress.h"
#include "document/document.h"
#include "engine/question.h"

namespace ps {

/// A question with boxes to tick or a line to write on. `document` is that of its step.
std::string question_html(const LessonQuestion& question, int number, const Document& document);

/// The measured answer with its reason and, for a choice, the wrong answers with what is wrong about each. Throws as
/// measure_answer() does.
std::string answer_html(const LessonQuestion& question, int number, Progress& progress);

}  // namespace ps
