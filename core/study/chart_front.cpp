#include "study/chart_front.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/chart_style.h"

namespace ps {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

double as_rmse(double psnr) { return std::pow(10.0, -psnr / 20); }
double as_psnr(double rmse) { return rmse > 0 ? -20 * std::log10(rmse) : unbounded; }

bool times_known(const ChartPoint& point) {
  return static_cast<int>(point.samples_ms.size()) >= least_runs_for_quartiles;
}

bool equal_cost(const Chart& chart, const ChartPoint& a, const ChartPoint& b) {
  return chart.across != ChartAcross::time && a.cost.median == b.cost.median;
}

}  // namespace

std::optional<double> chart_noise(const Chart& chart) {
  Reference reference;
  reference.halves = chart.reference_halves;
  const auto noise = reference_noise(reference, chart.metric);
  return noise && !std::isnan(*noise) ? noise : std::nullopt;
}

ErrorRange error_range(ErrorMetric metric, double error, std::optional<double> noise) {
  if (!noise) return {error, error};
  switch (metric) {
  case ErrorMetric::mae:
  case ErrorMetric::rmse:
  case ErrorMetric::max:
  case ErrorMetric::flip:
    return {std::max(0.0, error - *noise), error + *noise};
  case ErrorMetric::psnr: {
    const double width = as_rmse(*noise), middle = as_rmse(error);
    return {as_psnr(middle - width), as_psnr(middle + width)};
  }
  case ErrorMetric::ssim:
    return {std::min(1.0, error + (1 - *noise)), error - (1 - *noise)};
  }
  return {error, error};
}

bool surely_cheaper(const Chart& chart, const ChartPoint& a, const ChartPoint& b) {
  if (chart.across != ChartAcross::time) return a.cost.median < b.cost.median;
  return times_known(a) && times_known(b) && a.cost.median < b.cost.median && !within_noise(a.cost, b.cost);
}

bool surely_more_exact(const Chart& chart, const ChartPoint& a, const ChartPoint& b) {
  return better_error(chart.metric, error_range(chart.metric, a.error, chart_noise(chart)).worst, b.error) &&
         better_error(chart.metric, a.error, b.error);
}

FrontPlace front_place(const Chart& chart, const ChartPoint& point) {
  if (!point.ranked()) return FrontPlace::beaten;
  bool may_be_beaten = false;
  for (const ChartPoint& other : chart.points) {
    if (&other == &point || !other.ranked()) continue;
    const bool same_cost = equal_cost(chart, other, point), same_error = other.error == point.error;
    const bool cheaper = surely_cheaper(chart, other, point), better = surely_more_exact(chart, other, point);
    if ((cheaper && (better || same_error)) || (better && same_cost)) return FrontPlace::beaten;
    const bool costs_more = surely_cheaper(chart, point, other), worse = surely_more_exact(chart, point, other);
    if (!costs_more && !worse && !(same_cost && same_error)) may_be_beaten = true;
  }
  return may_be_beaten ? FrontPlace::tie : FrontPlace::front;
}

std::vector<Vec2d> front_staircase(const Chart& chart) {
  std::vector<Vec2d> corners;
  for (const ChartPoint* point : front_by_cost(chart)) {
    if (!corners.empty()) corners.emplace_back(point->cost.median, corners.back().y);
    corners.emplace_back(point->cost.median, point->error);
  }
  return corners;
}

std::vector<FrontBandPart> front_band(const Chart& chart) {
  struct Corner {
    Quartiles cost;
    ErrorRange error;
  };
  const std::optional<double> noise = chart_noise(chart);
  std::vector<Corner> corners;
  std::vector<double> costs;
  for (const ChartPoint& point : chart.points) {
    if (!point.ranked() || std::isnan(point.error)) continue;
    corners.push_back({point.cost, error_range(chart.metric, point.error, noise)});
    costs.insert(costs.end(), {point.cost.q1, point.cost.q3});
  }
  std::sort(costs.begin(), costs.end());
  costs.erase(std::unique(costs.begin(), costs.end()), costs.end());
  const double nothing_yet = error_metric(chart.metric).higher_is_better ? -unbounded : unbounded;
  const auto better = [&](double a, double b) { return better_error(chart.metric, a, b); };
  std::vector<FrontBandPart> parts;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    FrontBandPart part{costs[i], i + 1 < costs.size() ? costs[i + 1] : unbounded, {nothing_yet, nothing_yet}};
    for (const Corner& corner : corners) {
      if (corner.cost.q1 <= costs[i] && better(corner.error.best, part.error.best)) part.error.best = corner.error.best;
      if (corner.cost.q3 <= costs[i] && better(corner.error.worst, part.error.worst))
        part.error.worst = corner.error.worst;
    }
    if (part.error.best != part.error.worst) parts.push_back(part);
  }
  return parts;
}

}  // namespace ps
