#pragma once
#include "raster/clear/coverage/input.h"

namespace ps::raster {

enum class CellVerdict { outside, inside, partly };

/// What the edges say about a box of samples as a whole, from the corners where each is smallest and largest. `edge` is
/// the one that the box is wholly outside of, or else the first that cuts it; -1 if it is inside.
struct CellTest {
  CellVerdict verdict = CellVerdict::inside;
  int edge = -1;
};

inline CellTest test_cell(const EdgeFunctions& edges, const TileRect& box) {
  const auto corner = edges.at(box.x0, box.y0);
  CellTest test;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t across = edges.step_x[i] * (box.x1 - 1 - box.x0), down = edges.step_y[i] * (box.y1 - 1 - box.y0);
    const std::int64_t largest = corner[i] + std::max<std::int64_t>(across, 0) + std::max<std::int64_t>(down, 0);
    const std::int64_t smallest = corner[i] + std::min<std::int64_t>(across, 0) + std::min<std::int64_t>(down, 0);
    if (largest <= edges.threshold[i]) return {CellVerdict::outside, static_cast<int>(i)};
    if (smallest <= edges.threshold[i] && test.edge < 0) test = {CellVerdict::partly, static_cast<int>(i)};
  }
  return test;
}

/// The largest multiple of `size`, a power of two, that is not above a column or row of the picture.
inline int cell_start(int pixel, int size) { return pixel - pixel % size; }

}  // namespace ps::raster
