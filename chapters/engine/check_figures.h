#pragma once
#include <string>
#include <vector>

#include "base/progress.h"
#include "engine/lesson.h"

namespace ps {

/// The numbers in figures of a step that are not those of the step's own pixel, to half a percent: a sentence for each,
/// with file, line and column. Throws InputError where the step cannot be shown, and Cancelled.
std::vector<std::string> figure_faults(const Lesson& lesson, int step, Progress& progress);

}  // namespace ps
