#pragma once
#include <imgui.h>

#include <string>

#include "gui/panels/studies/method_signs.h"
#include "study/stability/figures.h"

namespace ps::gui {

/// The height that all bars of a figure take, with names and title, in an area of this width.
float bars_height(const ExperimentFigure& figure, const MethodNames& names, float width);

/// One row for each bar of a figure: its name, and the result of both methods as bars with their values. Answers the
/// name under the mouse in full, if it was cut.
std::string draw_bars(ImDrawList& list, const Area& area, const ExperimentFigure& figure, const MethodNames& names,
                      ImVec2 mouse);

}  // namespace ps::gui
