#pragma once
#include "raster/clear/coverage/input.h"

namespace ps::raster {

/// Edge functions stepped from sample to sample (CGPP 15.6.4; Pineda 1988): additions only, and exact, since the values
/// are integers.
template <class Sink>
void walk_incremental(const CoverageInput& input, const TileRect& box, Sink& sink) {
  const EdgeFunctions& edges = input.edges;
  sink.test_all(box);
  std::array<std::int64_t, 3> row_values = edges.at(box.x0, box.y0);
  for (int row = box.y0; row < box.y1; ++row) {
    std::array<std::int64_t, 3> values = row_values;
    for (int column = box.x0; column < box.x1; ++column) {
      if (edges.inside(values)) sink.cover(column, row, values);
      for (std::size_t i = 0; i < 3; ++i) values[i] += edges.step_x[i];
    }
    for (std::size_t i = 0; i < 3; ++i) row_values[i] += edges.step_y[i];
  }
}

}  // namespace ps::raster
