#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/chart.h"
#include "study/label_layout.h"
#include "study/plot_frame.h"

namespace ps {

/// The place of a measured point in a drawing.
struct ChartMark {
  std::size_t point = 0;  ///< index into Chart::points
  Vec2d at{0, 0};
  double radius = 0;
};

/// Points that stand out: those that A and B show, and the one under the mouse.
struct ChartMarks {
  std::optional<std::size_t> a, b, hovered;
};

/// Where the labels of a plot are. Finding places takes a while, so they are kept until something moves.
struct ChartLabels {
  std::string key;  ///< what the places were found for
  std::vector<LabelWish> wishes;
  std::vector<LabelPlace> places;
};

/// Draws the axes of a chart into an area.
PlotFrame draw_chart_frame(Painter& painter, const PaintArea& area, const Chart& chart);
/// The marks of all points that have a place, in their order.
std::vector<ChartMark> place_marks(const Painter& painter, const Chart& chart, const PlotFrame& frame);
/// Draws front, marks and labels into the frame of draw_chart_frame(). A file shows the numbers of a mark to a pointer
/// over it.
void draw_chart(Painter& painter, const Chart& chart, const PlotFrame& frame, std::span<const ChartMark> marks,
                const ChartMarks& shown, ChartLabels& labels);

/// Fills the mark that a picture with these settings has in charts.
void fill_chart_mark(Painter& painter, const Settings& settings, const Vec2d& at, double radius);

/// The meaning of marks and lines, in as many lines as the area has room for.
void draw_chart_legend(Painter& painter, const PaintArea& area, const Chart& chart);
double chart_legend_height(const Painter& painter, int lines = 1);

}  // namespace ps
