#pragma once
#include <optional>
#include <vector>

#include "math/vec.h"
#include "study/chart.h"

namespace ps {

/// A time needs this many runs before its quartiles show how much it varies.
inline constexpr int least_runs_for_quartiles = 3;

/// What the reference of a chart may be wrong by, as reference_noise() gives it for the chart's metric. nullopt if it
/// is not known: errors then differ as soon as their numbers do.
std::optional<double> chart_noise(const Chart& chart);

/// Where an error may lie, since the reference is uncertain. In the metric's unit; for metrics that rise, `best` is the
/// larger one.
struct ErrorRange {
  double best = 0, worst = 0;
};
/// `noise` as from reference_noise(). Errors that add up lie within it on both sides. Noise of PSNR, which is a PSNR
/// itself, is taken as an RMSE, and that of SSIM as its distance from 1.
ErrorRange error_range(ErrorMetric metric, double error, std::optional<double> noise);

/// Does `a` cost less than `b`, whatever the noise? Their times are not within_noise() of each other, with
/// least_runs_for_quartiles of each. Work is counted without noise.
bool surely_cheaper(const Chart& chart, const ChartPoint& a, const ChartPoint& b);
/// Is the error of `a` better than that of `b` by more than the reference's uncertainty?
bool surely_more_exact(const Chart& chart, const ChartPoint& a, const ChartPoint& b);

/// Whether a point lies on the Pareto front, as far as that is known.
enum class FrontPlace {
  beaten,  ///< another point is surely as good in both, and surely better in one
  tie,     ///< no point surely beats it, but one may: noise decides
  front,   ///< no point can beat it
};
FrontPlace front_place(const Chart& chart, const ChartPoint& point);

/// The front as a staircase, the cheapest point first: positions (cost, error). Between two settings there is nothing,
/// so for the cost between theirs the cheaper one is the best that can be had.
std::vector<Vec2d> front_staircase(const Chart& chart);

/// A part of the band in which the front lies, whatever the noise: for all costs between the two, errors between the
/// two.
struct FrontBandPart {
  double cost_from = 0, cost_to = 0;  ///< the last part reaches to infinity
  ErrorRange error;                   ///< its worst side may be infinite
};
std::vector<FrontBandPart> front_band(const Chart& chart);

}  // namespace ps
