#pragma once
#include <imgui.h>

#include <string>

#include "gui/panels/pictures/picture_transform.h"
#include "study/axis.h"

namespace ps::gui {

/// The inside of a plot: where values lie on the screen.
struct PlotFrame {
  Area inner;
  PlotAxis x, y;
  ImVec2 at(double x_value, double y_value) const;
};

/// "10⁻⁵" for a power of ten that would be long, else four significant digits: a number as axes write it.
std::string axis_number(double value);

struct PlotTitles {
  std::string x;  ///< below the axis
  std::string y;  ///< above the plot, from the left, in lines where it is long
};

/// Draws grid, tick labels and titles into an area and answers where the inside lies. Labels that would touch one
/// another are left out.
PlotFrame draw_plot_frame(ImDrawList& list, const Area& area, const PlotAxis& x, const PlotAxis& y,
                          const PlotTitles& titles);

}  // namespace ps::gui
