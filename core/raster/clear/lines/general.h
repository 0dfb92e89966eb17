#pragma once
#include <cmath>
#include <cstdint>
#include <utility>

#include "math/vec.h"
#include "raster/clear/interpolate.h"

namespace ps::raster {

/// Calls visit(point, step) along the longer side of the line, one unit apart, both ends included (CGFS ch. 6). End
/// points need not be whole numbers. Order: rising along the longer side.
template <class Real, class Visit>
void walk_general(Vec2<Real> from, Vec2<Real> to, Visit&& visit) {
  const bool flat = std::abs(to.x - from.x) > std::abs(to.y - from.y);
  const int along = flat ? 0 : 1;
  const int across = 1 - along;
  if (to[along] < from[along]) std::swap(from, to);
  InterpolatedValues<Real> values(from[along], from[across], to[along], to[across]);
  int step = 0;
  for (Real i = from[along]; i <= to[along]; i += Real(1)) {
    Vec2<Real> point;
    point[along] = i;
    point[across] = values.at(static_cast<std::int64_t>(i - from[along]));
    visit(point, step++);
  }
}

}  // namespace ps::raster
