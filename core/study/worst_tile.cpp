#include "study/worst_tile.h"

#include <algorithm>

#include "base/check.h"
#include "image/flip.h"

namespace ps {

std::vector<double> tile_flips(const Image<Rgb8>& reference, const Image<Rgb8>& test) {
  constexpr int tile_size = 16;
  const int columns = std::max(1, test.width() / tile_size), rows = std::max(1, test.height() / tile_size);
  std::vector<double> means(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  if (reference == test) return means;
  const ScalarImage map = flip_map(reference, test);
  std::size_t tile = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int x0 = column * map.width() / columns, x1 = (column + 1) * map.width() / columns;
      const int y0 = row * map.height() / rows, y1 = (row + 1) * map.height() / rows;
      double sum = 0;
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) sum += map.at(x, y);
      means[tile++] = sum / ((x1 - x0) * (y1 - y0));
    }
  return means;
}

double worst_tile_flip(const Image<Rgb8>& reference, const Image<Rgb8>& test) {
  const std::vector<double> tiles = tile_flips(reference, test);
  return *std::max_element(tiles.begin(), tiles.end());
}

double worst_increase(const std::vector<double>& before, const std::vector<double>& after) {
  PS_ASSERT(before.size() == after.size(), "tiles of the same view");
  double worst = 0;
  for (std::size_t i = 0; i < before.size(); ++i) worst = std::max(worst, after[i] - before[i]);
  return worst;
}

}  // namespace ps
