#pragma once
#include <numeric>
#include <utility>
#include <vector>

#include "study/stability/support.h"

namespace ps::stability {

/// As many rows and columns as points, one point anywhere in each (Shirley 1991).
inline std::vector<Vec2d> n_rooks(int count, Random& random) {
  std::vector<int> column(static_cast<std::size_t>(count));
  std::iota(column.begin(), column.end(), 0);
  for (std::size_t i = column.size(); i > 1; --i) std::swap(column[i - 1], column[random.below(i)]);
  std::vector<Vec2d> points;
  for (const int x : column) {
    const auto y = static_cast<double>(points.size());
    points.push_back(Vec2d(x + random.unit(), y + random.unit()) / static_cast<double>(count));
  }
  return points;
}

}  // namespace ps::stability
