#pragma once
#include <string>

#include "image/painter.h"
#include "study/axis.h"

namespace ps {

/// The inside of a plot: where values lie in the drawing.
struct PlotFrame {
  PaintArea inner;
  PlotAxis x, y;
  Vec2d at(double x_value, double y_value) const;
};

/// "10⁵" for a power of ten that would be long; other numbers as `plain`.
std::string power_text(double value, std::string plain);

struct PlotTitles {
  std::string x;  ///< below the axis
  std::string y;  ///< above the plot, from the left, in lines where it is long
};

/// Draws grid, tick labels and titles into an area and answers where the inside lies. Labels that would touch one
/// another are left out.
PlotFrame draw_plot_frame(Painter& painter, const PaintArea& area, const PlotAxis& x, const PlotAxis& y,
                          const PlotTitles& titles);

}  // namespace ps
