#pragma once
#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "gui/panels/studies/plot_frame.h"
#include "study/stability/experiment.h"

namespace ps::gui {

/// Naive beside robust over a knob.
struct Curves {
  std::vector<StabilityRow> rows;  ///< of one series, in the order of the knob
  std::string knob, naive, robust, unit;
  SafeWindow safe;  ///< where the naive method may be used
};

/// The row whose knob is under the mouse, and how it was drawn.
struct CurvesDrawn {
  PlotFrame frame;
  std::optional<std::size_t> hovered;
  std::string cut;  ///< the name under the mouse in full, if it was cut
};

/// Draws both curves with their names. Purple crosses are the naive method, green rings the robust one. `marked` is a
/// row that is pointed out.
CurvesDrawn draw_curves(ImDrawList& list, const Area& area, const Curves& curves, ImVec2 mouse,
                        std::optional<std::size_t> marked);

}  // namespace ps::gui
