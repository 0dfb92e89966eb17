#include "study/chart_style.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "options/renderer_kind.h"
#include "study/chart_front.h"

namespace ps {

ChartAxes chart_axes(const Chart& chart) {
  std::vector<double> costs, errors;
  for (const ChartPoint& point : chart.points) {
    if (!point.placed()) continue;
    costs.insert(costs.end(), {point.cost.q1, point.cost.median, point.cost.q3});
    if (const auto whole = cost_with_upload(chart, point)) costs.push_back(*whole);
    errors.push_back(point.error);
  }
  const ErrorMetricRow& row = error_metric(chart.metric);
  ChartAxes axes;
  axes.cost = fit_axis(costs, AxisScale::logarithmic);
  switch (chart.across) {
  case ChartAcross::time:
    axes.cost_title = "time of one picture (ms)";
    break;
  case ChartAcross::work:
    axes.cost_title = "work: rays, tests, fragments and reads, counted";
    break;
  case ChartAcross::memory:
    axes.cost_title = "memory of one picture (MB)";
    break;
  }
  if (chart.across == ChartAcross::time) axes.cost_spread = ", median and quartiles";
  axes.error = fit_axis(errors, row.logarithmic ? AxisScale::logarithmic : AxisScale::linear);
  axes.error_title = std::string(row.label);
  if (row.in_levels) axes.error_title += chart.identity.values == "linear" ? " (unit floats)" : " (levels of 255)";
  const bool none_is_better = !errors.empty() && std::none_of(chart.points.begin(), chart.points.end(),
                                                              [](const ChartPoint& point) { return point.ranked(); });
  axes.error_sense = none_is_better         ? " from the picture as set"
                     : row.higher_is_better ? ", higher is better"
                                            : ", lower is better";
  return axes;
}

std::optional<double> cost_with_upload(const Chart& chart, const ChartPoint& point) {
  if (!point.placed() || !point.upload_ms || chart.across != ChartAcross::time) return {};
  return point.cost.median + point.upload_ms->median;
}

SweepNames chart_names(const Chart& chart) {
  std::vector<std::string> names;
  for (const ChartPoint& point : chart.points)
    names.push_back(point.what.name.empty() ? point.what.label : point.what.name);
  return split_names(names);
}

std::string mark_label(const Chart& chart, const ChartPoint& point, const std::string& name) {
  std::vector<std::string> notes;
  for (const LeftOutBrief& left : point.left_out)
    if (!std::all_of(chart.points.begin(), chart.points.end(), [&](const ChartPoint& other) {
          return std::find(other.left_out.begin(), other.left_out.end(), left) != other.left_out.end();
        }))
      notes.push_back(brief_text(left));
  if (point.tie) notes.insert(notes.begin(), "tie");
  if (point.standing == Standing::truth) notes.insert(notes.begin(), "the truth");
  return notes.empty() ? name : fmt::format("{} ({})", name, fmt::join(notes, ", "));
}

std::vector<const ChartPoint*> front_by_cost(const Chart& chart) {
  std::vector<const ChartPoint*> front;
  for (const ChartPoint& point : chart.points)
    if (point.on_front) front.push_back(&point);
  std::sort(front.begin(), front.end(),
            [](const ChartPoint* a, const ChartPoint* b) { return a->cost.median < b->cost.median; });
  return front;
}

std::string chart_provenance(const Chart& chart) {
  std::string text = fmt::format("Truth: {}.", chart.identity.reference);
  if (const auto noise = chart_noise(chart); noise && std::isfinite(*noise))
    text += fmt::format(" The reference itself is uncertain by {:.2g}.", *noise);
  if (!chart.identity.machinery.empty()) text += fmt::format(" Timed: {}.", chart.identity.machinery);
  for (const ChartPoint& point : chart.points)
    if (point.upload_ms) {
      const SweepNames names = chart_names(chart);
      text += fmt::format(" Upload of the scene, apart: {:.3g} ms for {}.", point.upload_ms->median,
                          names.parts[static_cast<std::size_t>(&point - chart.points.data())]);
    }
  for (const std::string& absent : chart.absent) text += fmt::format(" Not drawn: {}.", absent);
  if (!chart.damage.empty())
    text += fmt::format(" Damaged in the log: {}{}.", chart.damage.front(),
                        chart.damage.size() > 1 ? fmt::format(", and {} more", chart.damage.size() - 1) : "");
  return text;
}

Rgb8 mark_colour(const Settings& settings) {
  const bool twice = settings.precision == Precision::float64;
  switch (picture_way(settings.renderer)) {
  case PictureWay::rays:
    return twice ? Rgb8{140, 140, 170} : Rgb8{120, 100, 195};
  case PictureWay::fragments:
    if (mark_shape(settings.renderer) == MarkShape::diamond) return {175, 95, 120};
    return twice ? Rgb8{160, 145, 85} : Rgb8{130, 115, 20};
  case PictureWay::listing:
    return {60, 135, 145};
  }
  return {};
}

MarkShape mark_shape(Renderer renderer) {
  switch (picture_way(renderer)) {
  case PictureWay::rays:
    return MarkShape::circle;
  case PictureWay::fragments:
    return renderer_kind(renderer).added ? MarkShape::diamond : MarkShape::square;
  case PictureWay::listing:
    return MarkShape::triangle;
  }
  return MarkShape::circle;
}

double largest_memory(const Chart& chart) {
  double largest = 0;
  for (const ChartPoint& point : chart.points) largest = std::max(largest, point.memory_mb);
  return largest;
}

double mark_radius(double memory_mb, double largest_mb) {
  const double share = largest_mb > 0 ? std::clamp(memory_mb / largest_mb, 0.0, 1.0) : 0;
  const double small = smallest_mark_radius * smallest_mark_radius, large = largest_mark_radius * largest_mark_radius;
  return std::sqrt(small + share * (large - small));
}

}  // namespace ps
