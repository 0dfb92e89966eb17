#include "study/axis.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ps {
namespace {

constexpr double zero_share = 0.08;  ///< of the axis, kept for the place of zero

double nice_step(double span) {
  const double rough = span / 5;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power) return factor * power;
  return 10 * power;
}

std::vector<Tick> linear_ticks(const PlotAxis& axis) {
  std::vector<Tick> ticks;
  const double fit = nice_step(axis.high - axis.low);
  const double step = axis.whole ? std::max(fit, 1.0) : fit;
  for (double k = std::ceil(axis.low / step); k * step <= axis.high * (1 + 1e-12) + 1e-300; ++k)
    ticks.push_back({k * step, tick_text(k * step)});
  return ticks;
}

std::vector<Tick> log_ticks(const PlotAxis& axis) {
  std::vector<Tick> ticks;
  if (axis.zero_place) ticks.push_back({0, "0"});
  const double decades = std::log10(axis.high / axis.low);
  if (decades < 0.7) {  // too few round powers
    for (Tick& tick : linear_ticks(axis)) ticks.push_back(std::move(tick));
    return ticks;
  }
  const int every = decades > 8 ? 2 : 1;
  for (int power = static_cast<int>(std::floor(std::log10(axis.low))); std::pow(10.0, power) <= axis.high; ++power)
    for (const int digit : {1, 2, 3, 4, 5, 6, 7, 8, 9}) {
      const double value = digit * std::pow(10.0, power);
      if (value < axis.low || value > axis.high) continue;
      const bool labelled = (digit == 1 && power % every == 0) || (decades < 2.2 && (digit == 2 || digit == 5));
      if (labelled || decades < 4) ticks.push_back({value, labelled ? tick_text(value) : ""});
    }
  return ticks;
}

}  // namespace

double PlotAxis::place(double value) const {
  if (std::isnan(value)) return 0;
  if (scale == AxisScale::linear) return std::clamp((value - low) / (high - low), 0.0, 1.0);
  if (value <= 0) return zero_place ? zero_share / 2 : 0;
  const double start = zero_place ? zero_share : 0;
  const double share = std::log(value / low) / std::log(high / low);
  return std::clamp(start + (1 - start) * share, start, 1.0);
}

std::vector<Tick> PlotAxis::ticks() const {
  return scale == AxisScale::linear ? linear_ticks(*this) : log_ticks(*this);
}

std::optional<double> PlotAxis::break_place() const {
  if (scale == AxisScale::linear || !zero_place) return {};
  return 0.8 * zero_share;
}

PlotAxis fit_axis(const std::vector<double>& values, AxisScale scale) {
  PlotAxis axis;
  axis.scale = scale;
  double low = INFINITY, high = -INFINITY;
  axis.whole = !values.empty();
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    axis.whole = axis.whole && value == std::floor(value);
    if (scale == AxisScale::logarithmic && value <= 0) {
      axis.zero_place = true;
      continue;
    }
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) low = high = 1;
  if (scale == AxisScale::logarithmic) {
    const double room = std::max(std::pow(high / low, 0.08), 1.2);
    axis.low = low / room;
    axis.high = high * room;
  } else {
    // Values that differ by less than a tick's digits are drawn at the centre: steps that small would vanish in the
    // sum.
    const double least_room = 1e-5 * std::max(std::abs(low), std::abs(high));
    const double room = high > low ? std::max(0.08 * (high - low), least_room) : high == 0 ? 1 : std::abs(high) / 2;
    axis.low = low >= 0 && low - room < 0 ? 0 : low - room;
    axis.high = high + room;
  }
  return axis;
}

std::string tick_text(double value) { return fmt::format("{:.6g}", value == 0 ? 0.0 : value); }

}  // namespace ps
