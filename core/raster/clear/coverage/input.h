#pragma once
#include "frame/region.h"
#include "raster/base/edge_function.h"

namespace ps::raster {

/// What a coverage strategy is given: a triangle whose vertices were rounded to the sub-pixel grid, so that all
/// strategies can answer the same question, and exactly. A strategy walks the pixels of a box, a part of `whole`, and
/// reports to its sink:
///   test(column, row)             a sample was tested by itself
///   test_all(box)                 all samples of the box were
///   region(box)                   a row, a cell or a piece with this box was tested as a whole
///   cover(column, row[, values])  the sample is covered; at most once for each; values are those of the edges there
struct CoverageInput {
  std::array<FixedPoint, 3> corners{};
  EdgeFunctions edges;
  CoverageGrid grid;
  TileRect whole;  ///< the triangle's samples inside the picture; steps start here, wherever tiles begin
  Projection projection = Projection::perspective;
};

/// The sample's place inside its pixel, in units of FixedPoint.
inline FixedPoint sample_offset(const CoverageGrid& grid) {
  const auto unit = static_cast<double>(fixed_unit(grid.subpixel_bits));
  return {static_cast<std::int32_t>(grid.sample.x * unit), static_cast<std::int32_t>(grid.sample.y * unit)};
}

/// Division that rounds down also below zero. `divisor` is positive.
inline std::int64_t floor_divide(std::int64_t value, std::int64_t divisor) {
  const std::int64_t quotient = value / divisor;
  return value - quotient * divisor < 0 ? quotient - 1 : quotient;
}

}  // namespace ps::raster
