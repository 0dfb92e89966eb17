#pragma once
#include <span>
#include <vector>

#include "math/vec.h"

namespace ps::raster {

/// One row of a filled polygon: columns left to right, both included.
struct PolygonRow {
  int y = 0;
  int left = 0, right = 0;
  bool operator==(const PolygonRow&) const = default;
};

/// The rows of a convex polygon given by whole pixels, from its lowest y to its highest (LAB 4): every edge is walked
/// by interpolation, and each row keeps the leftmost and rightmost pixel met. All edges count as inside, so neighbours
/// overlap on theirs. Empty for no corners.
std::vector<PolygonRow> polygon_rows(std::span<const Vec2i> corners);

}  // namespace ps::raster
