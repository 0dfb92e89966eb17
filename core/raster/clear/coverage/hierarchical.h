#pragma once
#include "raster/clear/coverage/cell.h"

namespace ps::raster {

/// Cells of 64, 16 and 4 pixels, then single samples: a cell that an edge has wholly outside is dropped with all its
/// samples, one inside all edges is taken (CGPP 15.6.6.1, after Greene).
constexpr int coarsest_cell = 64;
constexpr int cells_across = 4;  ///< of the next size, in a cell

template <class Sink>
void walk_cell(const CoverageInput& input, const TileRect& box, int x, int y, int size, Sink& sink) {
  const TileRect cell = common_part({x, y, x + size, y + size}, input.whole);
  const TileRect wanted = common_part(cell, box);
  if (is_empty(wanted)) return;
  if (size == 1) {
    const auto values = input.edges.at(x, y);
    sink.test(x, y);
    if (input.edges.inside(values)) sink.cover(x, y, values);
    return;
  }
  sink.region(wanted);
  switch (test_cell(input.edges, cell).verdict) {
  case CellVerdict::outside:
    return;
  case CellVerdict::inside:
    for (int row = wanted.y0; row < wanted.y1; ++row)
      for (int column = wanted.x0; column < wanted.x1; ++column) sink.cover(column, row);
    return;
  case CellVerdict::partly:
    const int part = size / cells_across;
    for (int down = 0; down < size; down += part)
      for (int across = 0; across < size; across += part) walk_cell(input, box, x + across, y + down, part, sink);
    return;
  }
}

template <class Sink>
void walk_hierarchy(const CoverageInput& input, const TileRect& box, Sink& sink) {
  for (int y = cell_start(box.y0, coarsest_cell); y < box.y1; y += coarsest_cell)
    for (int x = cell_start(box.x0, coarsest_cell); x < box.x1; x += coarsest_cell)
      walk_cell(input, box, x, y, coarsest_cell, sink);
}

}  // namespace ps::raster
