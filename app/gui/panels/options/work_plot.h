#pragma once
#include <optional>

#include "gui/panels/options/work_log.h"

namespace ps::gui {

/// The height of the two plots, in window pixels.
float work_plots_height();

/// Two plots side by side over the last changes: the time of each picture's run, and its counted work. Answers the step
/// (History::Entry::id) whose point was clicked. `now` is the step that is shown.
std::optional<std::uint64_t> work_plots(const WorkLog& log, std::uint64_t now);

}  // namespace ps::gui
