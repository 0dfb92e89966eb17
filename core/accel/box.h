#pragma once
#include <algorithm>
#include <limits>

#include "math/vec.h"

namespace ps {

/// An axis-aligned box; empty until something is included.
template <class Real>
struct Box {
  Vec3<Real> low{std::numeric_limits<Real>::infinity()};
  Vec3<Real> high{-std::numeric_limits<Real>::infinity()};

  void include(const Vec3<Real>& point) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  void include(const Box& other) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }
  bool empty() const { return !(low.x <= high.x); }
  /// Half of the surface area; 0 for an empty box.
  Real half_area() const {
    if (empty()) return 0;
    const Vec3<Real> size = high - low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
  }
  /// The largest absolute value of a coordinate; 0 for an empty box.
  Real reach() const {
    Real result = 0;
    if (empty()) return result;
    for (int axis = 0; axis < 3; ++axis)
      result = std::max({result, low[axis] < 0 ? -low[axis] : low[axis], high[axis] < 0 ? -high[axis] : high[axis]});
    return result;
  }
};

}  // namespace ps
