#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "math/vec.h"

namespace ps::raster {

/// Where a row of a polygon begins or ends: a pixel that an edge passes.
struct PolygonRowEnd {
  int x = 0;
  int edge = 0;           ///< from the vertex of this number to the next
  std::int64_t step = 0;  ///< of the walk along the edge, 0 at its first vertex
  std::int64_t steps = 0;
  /// How far along its edge: 0 at the first vertex, 1 at the second.
  template <class Real>
  Real along() const {
    return steps == 0 ? Real(0) : static_cast<Real>(step) / static_cast<Real>(steps);
  }
  bool operator==(const PolygonRowEnd&) const = default;
};

/// One row of a filled polygon: columns left to right, both included.
struct PolygonRow {
  int y = 0;
  PolygonRowEnd left, right;
  bool operator==(const PolygonRow&) const = default;
};

/// Which rows are asked for, both included.
struct RowRange {
  int first = std::numeric_limits<int>::min();
  int last = std::numeric_limits<int>::max();
};

/// The rows of a convex polygon given by whole pixels, from its lowest y to its highest (LAB 4, "Interpolate" and
/// "ComputePolygonRows"): every edge is walked from its first vertex to its second in as many steps as its longer side
/// has pixels, positions lose their fraction downwards, and each row keeps the leftmost and the rightmost pixel met,
/// the first of several. All edges count as inside, so neighbours overlap on theirs. The walk is not repeated step by
/// step: in a row only an edge's first and last step can be an end. Coordinates must lie within 2^30; empty for no
/// vertices.
std::vector<PolygonRow> polygon_rows(std::span<const Vec2i> vertices, RowRange range = {});

}  // namespace ps::raster
