#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "math/vec.h"

namespace ps {

/// A rectangle that drawings are cut to.
struct ClipWindow {
  Vec2d low{0, 0}, high{1, 1};
};

/// The part of a segment inside the window (Liang and Barsky 1984); nullopt if there is none.
inline std::optional<std::array<Vec2d, 2>> clip_segment(const Vec2d& from, const Vec2d& to, const ClipWindow& window) {
  double enter = 0, leave = 1;
  const Vec2d along = to - from;
  for (int axis = 0; axis < 2; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const double room = side < 0 ? from[axis] - window.low[axis] : window.high[axis] - from[axis];
      const double step = side * along[axis];
      if (step == 0 && room < 0) return {};
      if (step > 0) leave = std::min(leave, room / step);
      if (step < 0) enter = std::max(enter, room / step);
    }
  }
  if (enter > leave) return {};
  return std::array<Vec2d, 2>{from + along * enter, from + along * leave};
}

/// The part of a convex polygon inside the window (Sutherland and Hodgman 1974); empty if there is none.
inline std::vector<Vec2d> clip_polygon(std::vector<Vec2d> corners, const ClipWindow& window) {
  for (int axis = 0; axis < 2; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto room = [&](const Vec2d& p) {
        return side < 0 ? p[axis] - window.low[axis] : window.high[axis] - p[axis];
      };
      std::vector<Vec2d> kept;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double at_a = room(a), at_b = room(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a < 0) != (at_b < 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
      }
      corners = std::move(kept);
    }
  return corners;
}

}  // namespace ps
