#pragma once
#include <optional>
#include <string>
#include <vector>

#include "image/painter.h"
#include "study/axis.h"
#include "study/chart.h"

namespace ps {

/// How a chart is drawn, in the window and in files alike.
struct ChartAxes {
  PlotAxis cost, error;
  std::string cost_title;   ///< "time of one picture (ms)"
  std::string cost_spread;  ///< ", median and quartiles"; empty for work
  std::string error_title;  ///< "RMSE (levels of 255)"
  std::string error_sense;  ///< ", lower is better"; of pictures that differ on purpose, what they differ from
};
/// Axes that hold all measured points. PSNR and SSIM grow upwards as they are: better is then up, not down.
ChartAxes chart_axes(const Chart& chart);

/// Where the cost of a point would lie if the upload of the scene were in it; nullopt where there is none, and where
/// work is the horizontal axis.
std::optional<double> cost_with_upload(const Chart& chart, const ChartPoint& point);

/// The names of all points, in their order, and what they have in common: "Samples per pixel", and "1", "4", "16".
SweepNames chart_names(const Chart& chart);
/// What is beside the mark of a point: its part of chart_names(), whether it is the truth or a tie, and what it leaves
/// out and others do not.
std::string mark_label(const Chart& chart, const ChartPoint& point, const std::string& name);

/// Points on the front, the cheapest first.
std::vector<const ChartPoint*> front_by_cost(const Chart& chart);
/// The sentences under a chart: what its errors are measured against and how uncertain that is, which code its times
/// are of, and whether its log was damaged.
std::string chart_provenance(const Chart& chart);

/// One for each renderer and precision: violet against ochre, so that colour-blind eyes can separate them as well, and
/// none of the colours of A and B. The shape says the renderer again.
Rgb8 mark_colour(const Settings& settings);

/// What the mark of a renderer looks like.
enum class MarkShape {
  circle,    ///< rays
  square,    ///< fragments
  diamond,   ///< fragments, of a renderer that comes with the program beside ours
  triangle,  ///< a listing
};
MarkShape mark_shape(Renderer renderer);

/// The Pareto front, and the area in which it may lie.
inline constexpr Stroke chart_front{{Role::ink}, 1.5, {6, 4}};
inline constexpr Tint chart_band{Role::ink, 0.1};

inline constexpr double smallest_mark_radius = 4, largest_mark_radius = 9;
inline constexpr double truth_ring_gap =
    3;  ///< between the mark of the truth and the ring around it, pixels at scale 1
/// The area of a mark grows with the memory, in pixels at scale 1.
double mark_radius(double memory_mb, double largest_mb);
/// The largest memory of a point, in MB.
double largest_memory(const Chart& chart);

}  // namespace ps
