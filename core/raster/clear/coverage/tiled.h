#pragma once
#include <bit>

#include "raster/clear/coverage/cell.h"

namespace ps::raster {

/// Tiles of 8 x 8 samples, whose answer for one edge fits into 64 bits: bit 8 * row + column is set where the sample
/// lies inside. Three of them and a logical AND decide the tile (CGPP 15.6.6.1 and 15.6.6.2).
constexpr int mask_tile = 8;

/// A row's eight bits from column `n` on; 8 = none.
constexpr std::array<std::uint8_t, 9> row_from{0xFF, 0xFE, 0xFC, 0xF8, 0xF0, 0xE0, 0xC0, 0x80, 0x00};

inline std::uint64_t edge_mask(const EdgeFunctions& edges, std::size_t i, int x, int y) {
  const std::int64_t step = edges.step_x[i];
  std::int64_t value = edges.at(x, y)[i];
  std::uint64_t mask = 0;
  for (int row = 0; row < mask_tile; ++row, value += edges.step_y[i]) {
    std::uint8_t bits = 0;
    if (step == 0) {
      bits = value > edges.threshold[i] ? row_from[0] : row_from[8];
    } else if (step > 0) {  // inside from a column on
      const std::int64_t first = floor_divide(edges.threshold[i] - value, step) + 1;
      bits = row_from[static_cast<std::size_t>(std::clamp<std::int64_t>(first, 0, 8))];
    } else {  // inside up to a column
      const std::int64_t last = floor_divide(value - edges.threshold[i] - 1, -step);
      bits = static_cast<std::uint8_t>(~row_from[static_cast<std::size_t>(std::clamp<std::int64_t>(last + 1, 0, 8))]);
    }
    mask |= std::uint64_t{bits} << (mask_tile * row);
  }
  return mask;
}

template <class Sink>
void walk_tile(const CoverageInput& input, const TileRect& box, int x, int y, Sink& sink) {
  const TileRect tile = common_part({x, y, x + mask_tile, y + mask_tile}, input.whole);
  const TileRect wanted = common_part(tile, box);
  if (is_empty(wanted)) return;
  sink.region(wanted);
  const CellVerdict verdict = test_cell(input.edges, tile).verdict;
  if (verdict == CellVerdict::outside) return;
  std::uint64_t mask = ~std::uint64_t{0};
  if (verdict == CellVerdict::partly) {
    sink.region(wanted);
    for (std::size_t i = 0; i < 3; ++i) mask &= edge_mask(input.edges, i, x, y);
  }
  for (; mask != 0; mask &= mask - 1) {
    const int bit = std::countr_zero(mask);
    const int column = x + bit % mask_tile, row = y + bit / mask_tile;
    if (wanted.contains(column, row)) sink.cover(column, row);
  }
}

template <class Sink>
void walk_tiles(const CoverageInput& input, const TileRect& box, Sink& sink) {
  for (int y = cell_start(box.y0, mask_tile); y < box.y1; y += mask_tile)
    for (int x = cell_start(box.x0, mask_tile); x < box.x1; x += mask_tile) walk_tile(input, box, x, y, sink);
}

}  // namespace ps::raster
