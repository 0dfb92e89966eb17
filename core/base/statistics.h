#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"

namespace ps {

/// The median and the quartiles of repeated measurements, in the unit of the samples.
struct Quartiles {
  double q1 = 0, median = 0, q3 = 0;
};

/// Quantile `share` (0..1) of sorted samples, between neighbours by linear interpolation.
inline double quantile(const std::vector<double>& sorted, double share) {
  PS_ASSERT(!sorted.empty(), "a quantile needs samples");
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double weight = place - static_cast<double>(below);
  return sorted[below] * (1 - weight) + sorted[above] * weight;
}

inline Quartiles quartiles(std::vector<double> samples) {
  std::sort(samples.begin(), samples.end());
  return {quantile(samples, 0.25), quantile(samples, 0.5), quantile(samples, 0.75)};
}

/// The mean that suits ratios: twice as fast and half as fast give 1.
inline double geometric_mean(const std::vector<double>& ratios) {
  PS_ASSERT(!ratios.empty(), "a mean needs numbers");
  double sum = 0;
  for (const double ratio : ratios) sum += std::log(ratio);
  return std::exp(sum / static_cast<double>(ratios.size()));
}

}  // namespace ps
