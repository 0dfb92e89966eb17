#pragma once
#include <array>
#include <cmath>
#include <limits>

#include "accel/box.h"
#include "math/vec.h"

namespace ps {

/// Which slab_test() a ray asks for.
enum class SlabForm {
  robust,
  naive,    ///< as it is usually written; see naive_slab_test()
  from_ray  ///< robust, with planes as they are seen from the ray's origin: see SlabRay::origin
};

/// A ray made ready for many tests against boxes. Boxes are grown by `pad` on every side without touching them: the ray
/// starts `pad` nearer to the planes that it leaves through and `pad` farther from those that it enters through.
template <class Real>
struct SlabRay {
  Vec3<Real> inverse{0};           ///< 1 / direction; infinite for a zero component, with its sign
  Vec3<Real> entering{0};          ///< origin as seen from the planes where the ray enters
  Vec3<Real> leaving{0};           ///< likewise where it leaves
  std::array<bool, 3> negative{};  ///< the direction points down this axis
  SlabForm form = SlabForm::robust;
  /// From where planes, `entering` and `leaving` are seen: the world's origin, or with SlabForm::from_ray the ray's.
  /// Far from the world's origin the ray's coordinates are rounded by more than the pad, which would be lost in a sum.
  Vec3<Real> origin{0};

  SlabRay() = default;
  SlabRay(const Vec3<Real>& ray_origin, const Vec3<Real>& direction, Real pad, SlabForm slab_form = SlabForm::robust)
      : SlabRay(ray_origin, direction, Vec3<Real>(pad), slab_form) {}
  /// With a pad for each axis.
  SlabRay(const Vec3<Real>& ray_origin, const Vec3<Real>& direction, const Vec3<Real>& pad,
          SlabForm slab_form = SlabForm::robust)
      : form(slab_form), origin(form == SlabForm::from_ray ? ray_origin : Vec3<Real>(0)) {
    const Vec3<Real> start = ray_origin - origin;
    for (int axis = 0; axis < 3; ++axis) {
      inverse[axis] = Real(1) / direction[axis];
      const bool down = std::signbit(direction[axis]);
      negative[static_cast<std::size_t>(axis)] = down;
      entering[axis] = down ? start[axis] - pad[axis] : start[axis] + pad[axis];
      leaving[axis] = down ? start[axis] + pad[axis] : start[axis] - pad[axis];
    }
  }
};

/// The range of t in which the ray is inside the box, within [0, limit]; near > far where it never is.
template <class Real>
struct SlabRange {
  Real near = 0, far = 0;
  bool hit() const { return near <= far; }
};

/// The slab test as it is usually written: planes are sorted by their t, none is grown. NaN (0 * infinity: the ray
/// runs in a plane of the box) becomes the range, and the box is missed; so are boxes that a ray touches at an edge or
/// a corner.
template <class Real>
inline SlabRange<Real> naive_slab_test(const SlabRay<Real>& ray, const Box<Real>& box, Real limit) {
  SlabRange<Real> range{0, limit};
  for (int axis = 0; axis < 3; ++axis) {
    const Real low = (box.low[axis] - ray.entering[axis]) * ray.inverse[axis];
    const Real high = (box.high[axis] - ray.leaving[axis]) * ray.inverse[axis];
    range.near = std::max(std::min(low, high), range.near);
    range.far = std::min(std::max(low, high), range.far);
  }
  return range;
}

/// By how much the far end of a range grows to make up for its rounding error and the near end's (Ize).
template <class Real>
inline constexpr Real slab_growth = 1 + 2 * (3 * (std::numeric_limits<Real>::epsilon() / 2) /
                                             (1 - 3 * (std::numeric_limits<Real>::epsilon() / 2)));

/// The slab test (Kay and Kajiya) in Ize's robust form (JCGT 2013): the far end grows by the rounding error of the near
/// and the far end, so that no ray is lost between two boxes that touch. Planes are taken in the order in which the ray
/// meets them, and comparisons are false for NaN (0 * infinity), which then leaves the range as it is. The box is as
/// seen from ray.origin.
template <class Real>
inline SlabRange<Real> robust_slab_test(const SlabRay<Real>& ray, const Box<Real>& box, Real limit) {
  SlabRange<Real> range{0, limit};
  for (int axis = 0; axis < 3; ++axis) {
    const bool down = ray.negative[static_cast<std::size_t>(axis)];
    const Real near = ((down ? box.high[axis] : box.low[axis]) - ray.entering[axis]) * ray.inverse[axis];
    const Real far =
        (((down ? box.low[axis] : box.high[axis]) - ray.leaving[axis]) * ray.inverse[axis]) * slab_growth<Real>;
    if (near > range.near) range.near = near;
    if (far < range.far) range.far = far;
  }
  return range;
}

/// In the ray's own form.
template <class Real>
inline SlabRange<Real> slab_test(const SlabRay<Real>& ray, const Box<Real>& box, Real limit) {
  if (ray.form == SlabForm::robust) [[likely]]
    return robust_slab_test(ray, box, limit);
  if (ray.form == SlabForm::naive) return naive_slab_test(ray, box, limit);
  return robust_slab_test(ray, {box.low - ray.origin, box.high - ray.origin}, limit);
}

}  // namespace ps
