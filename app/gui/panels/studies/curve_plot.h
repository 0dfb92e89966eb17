#pragma once
#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "gui/panels/studies/method_signs.h"
#include "study/plot_frame.h"
#include "study/stability/figures.h"

namespace ps::gui {

/// Naive beside robust over a knob.
struct Curves {
  ExperimentFigure figure;  ///< a curve
  std::string knob;
  MethodNames names;
  SafeWindow safe;  ///< where the naive method may be used
};

/// The row whose knob is under the mouse, and how it was drawn.
struct CurvesDrawn {
  PlotFrame frame;
  std::optional<std::size_t> hovered;
  std::string cut;  ///< the name under the mouse in full, if it was cut
};

/// Draws both curves with their names. Points are joined where something lies between them. `marked` is a
/// row that is pointed out.
CurvesDrawn draw_curves(ImDrawList& list, const Area& area, const Curves& curves, ImVec2 mouse,
                        std::optional<std::size_t> marked);

}  // namespace ps::gui
