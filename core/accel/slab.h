#pragma once
#include <array>
#include <cmath>
#include <limits>

#include "accel/box.h"
#include "math/vec.h"

namespace ps {

/// A ray made ready for many tests against boxes. Boxes are grown by `pad` on every side without touching them: the ray
/// starts `pad` nearer to the planes that it leaves through and `pad` farther from those that it enters through.
template <class Real>
struct SlabRay {
  Vec3<Real> inverse{0};           ///< 1 / direction; infinite for a zero component, with its sign
  Vec3<Real> entering{0};          ///< origin as seen from the planes where the ray enters
  Vec3<Real> leaving{0};           ///< likewise where it leaves
  std::array<bool, 3> negative{};  ///< the direction points down this axis

  SlabRay() = default;
  SlabRay(const Vec3<Real>& origin, const Vec3<Real>& direction, Real pad) {
    for (int axis = 0; axis < 3; ++axis) {
      inverse[axis] = Real(1) / direction[axis];
      const bool down = std::signbit(direction[axis]);
      negative[static_cast<std::size_t>(axis)] = down;
      entering[axis] = down ? origin[axis] - pad : origin[axis] + pad;
      leaving[axis] = down ? origin[axis] + pad : origin[axis] - pad;
    }
  }
};

/// The range of t in which the ray is inside the box, within [0, limit]; near > far where it never is.
template <class Real>
struct SlabRange {
  Real near = 0, far = 0;
  bool hit() const { return near <= far; }
};

/// The slab test (Kay and Kajiya) in Ize's robust form (JCGT 2013): the far end grows by the rounding error of the near
/// and the far end, so that no ray is lost between two boxes that touch. Planes are taken in the order in which the ray
/// meets them, and comparisons are false for NaN (0 * infinity), which then leaves the range as it is.
template <class Real>
inline SlabRange<Real> slab_test(const SlabRay<Real>& ray, const Box<Real>& box, Real limit) {
  constexpr Real half_ulp = std::numeric_limits<Real>::epsilon() / 2;
  constexpr Real grow = 1 + 2 * (3 * half_ulp / (1 - 3 * half_ulp));
  SlabRange<Real> range{0, limit};
  for (int axis = 0; axis < 3; ++axis) {
    const bool down = ray.negative[static_cast<std::size_t>(axis)];
    const Real near = ((down ? box.high[axis] : box.low[axis]) - ray.entering[axis]) * ray.inverse[axis];
    const Real far = (((down ? box.low[axis] : box.high[axis]) - ray.leaving[axis]) * ray.inverse[axis]) * grow;
    if (near > range.near) range.near = near;
    if (far < range.far) range.far = far;
  }
  return range;
}

}  // namespace ps
