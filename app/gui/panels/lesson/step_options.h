#pragma once
#include <vector>

#include "engine/lesson.h"
#include "options/option.h"

namespace ps::gui {

/// The options that a step is about and that have no control in its text: those that it names in bold or in a link,
/// and those that it sets differently in A and B, or else all that it sets. Where it asks for the wrong line of a
/// listing, what it sets is not what it is about.
std::vector<const Option*> step_options(const LessonStep& step);

}  // namespace ps::gui
