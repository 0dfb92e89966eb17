#pragma once
#include <utility>

#include "math/vec.h"

namespace ps::raster {

/// The line as a function of one axis alone (CGFS ch. 6, the first attempt): steps along `Along` (0 = x, 1 = y) and
/// adds the slope to the other coordinate. Lines that are steeper than 45 degrees to that axis get gaps, and one
/// perpendicular to it becomes a single point.
template <int Along, class Real, class Visit>
void walk_single_axis(Vec2<Real> from, Vec2<Real> to, Visit&& visit) {
  constexpr int across = 1 - Along;
  if (to[Along] < from[Along]) std::swap(from, to);
  const Real slope = (to[across] - from[across]) / (to[Along] - from[Along]);
  int step = 0;
  Vec2<Real> point = from;
  for (; point[Along] <= to[Along]; point[Along] += Real(1)) {
    visit(point, step++);
    point[across] += slope;
  }
}

/// y = f(x): one pixel in each column.
template <class Real, class Visit>
void walk_y_of_x(Vec2<Real> from, Vec2<Real> to, Visit&& visit) {
  walk_single_axis<0>(from, to, visit);
}

/// x = f(y): one pixel in each row.
template <class Real, class Visit>
void walk_x_of_y(Vec2<Real> from, Vec2<Real> to, Visit&& visit) {
  walk_single_axis<1>(from, to, visit);
}

}  // namespace ps::raster
