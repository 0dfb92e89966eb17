#pragma once
#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace ps::raster {

/// One interpolation of both coordinates at once (LAB 3): as many steps as the longer side has pixels, each adding the
/// same small vector, from the first point to the second.
template <class Real, class Visit>
void walk_interpolated(Vec2<Real> from, Vec2<Real> to, Visit&& visit) {
  const Real longer = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  const int steps = static_cast<int>(longer);
  const Real divisor = static_cast<Real>(std::max(steps, 1));
  const Vec2<Real> stride{(to.x - from.x) / divisor, (to.y - from.y) / divisor};
  Vec2<Real> point = from;
  for (int step = 0; step <= steps; ++step) {
    visit(point, step);
    point += stride;
  }
}

}  // namespace ps::raster
