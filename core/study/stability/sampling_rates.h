#pragma once
#include <array>

#include "study/stability/support.h"

namespace ps::stability {

/// An edge through the pixel, dark on one side.
struct Edge {
  Vec2d normal;
  double offset;
};

/// The area of the unit square with normal . p < offset: clip the square, then the shoelace formula.
double area_below(const Edge& edge);

/// Numbers of samples between which a rate is taken.
inline constexpr std::array rate_counts{16, 64, 256, 1024};
using RateErrors = std::array<double, rate_counts.size()>;

/// The power of the number of samples that the errors follow best: the slope of their logarithms.
double rate(const RateErrors& errors);

/// Errors of pixels, and their rates, that the edges of supersampling-rate leave out: patterns on edges at 45 degrees,
/// on a smooth wave and on a board, and two patterns that the program does not offer.
void add_sampling_rates(Rows& rows, const StabilityRun& run);

}  // namespace ps::stability
