#include "study/worst_tile.h"

#include <algorithm>

#include "image/flip.h"

namespace ps {

double worst_tile_flip(const Image<Rgb8>& reference, const Image<Rgb8>& test) {
  if (reference == test) return 0;
  constexpr int tile_size = 16;
  const ScalarImage map = flip_map(reference, test);
  const int columns = std::max(1, map.width() / tile_size), rows = std::max(1, map.height() / tile_size);
  double worst = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int x0 = column * map.width() / columns, x1 = (column + 1) * map.width() / columns;
      const int y0 = row * map.height() / rows, y1 = (row + 1) * map.height() / rows;
      double sum = 0;
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) sum += map.at(x, y);
      worst = std::max(worst, sum / ((x1 - x0) * (y1 - y0)));
    }
  return worst;
}

}  // namespace ps
