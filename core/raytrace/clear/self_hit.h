#pragma once
#include "math/unit.h"
#include "raytrace/clear/surface_point.h"

namespace ps {

/// A point on a triangle moved off it, to the side that `direction` points to, by the bound of its own rounding error
/// (pbrt 6.8): n.e along n, then one representable number further.
template <class Real>
inline Vec3<Real> offset_from_triangle(const SurfacePoint<Real>& surface, const Vec3<Real>& direction) {
  const Vec3<Real>& n = surface.geometric_normal;
  const Vec3<Real> size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
  const Real distance = dot(size, surface.point_error);
  const Vec3<Real> offset = n * (dot(direction, n) < 0 ? -distance : distance);
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  Vec3<Real> point = surface.point + offset;
  for (int axis = 0; axis < 3; ++axis) {
    if (offset[axis] > 0) point[axis] = std::nextafter(point[axis], infinity);
    if (offset[axis] < 0) point[axis] = std::nextafter(point[axis], -infinity);
  }
  return point;
}

/// The direction in which a surface reflects a ray that came from `to_eye`. A ray that enters a sphere sees its
/// outside, but where it all but passes by, rounding may place the point beyond the horizon, and the mirrored ray would
/// run into the ball. With self-hit = offset such a ray counts as what it is, parallel to the surface, and runs on.
template <class Real>
inline Vec3<Real> mirrored_direction(const SurfacePoint<Real>& surface, const Vec3<Real>& to_eye,
                                     const TraceInputs<Real>& inputs) {
  const Vec3<Real>& n = surface.shading_normal;
  const bool beyond_horizon = inputs.settings.self_hit == SelfHit::offset &&
                              primitive_of(*inputs.geometry, surface.primitive).kind == PrimitiveKind::sphere &&
                              surface.detail != leaves_sphere && dot(surface.geometric_normal, to_eye) < 0;
  const Real cosine = dot(n, to_eye);
  return mirror(to_eye, n, beyond_horizon && cosine < 0 ? Real(0) : cosine);
}

/// The ray that leaves a surface in `direction`, guarded against meeting that surface again at once:
///   offset       a sphere knows that one root is 0, a triangle is met only once, and points on triangles move by the
///                bound of their rounding error, so that neighbours are safe too: no false self-hit, no knob
///   epsilon      hits up to t = epsilon do not count (CGFS ch. 4)
///   normal_bump  it starts epsilon above the surface, on the side from which the surface was seen (CGPP)
///   exclusion    the sphere, triangle or solid that it leaves is not tested (CGPP 15.4.8): one that a ray can meet
///   twice
///                is then missed the second time
template <class Real>
inline Ray<Real> leaving_ray(const SurfacePoint<Real>& surface, const Vec3<Real>& direction, Real t_max, Real epsilon,
                             const TraceInputs<Real>& inputs) {
  Ray<Real> ray{surface.point, direction, Real(0), t_max, no_primitive};
  const Settings& settings = inputs.settings;
  switch (settings.self_hit) {
  case SelfHit::offset:
    ray.start = surface.primitive;
    ray.start_detail = surface.detail;
    if (primitive_of(*inputs.geometry, surface.primitive).kind == PrimitiveKind::triangle)
      ray.origin = offset_from_triangle(surface, direction);
    break;
  case SelfHit::epsilon:
    switch (settings.epsilon_unit) {
    case EpsilonUnit::ray_parameter:
      ray.t_min = epsilon;
      break;
    case EpsilonUnit::distance:
      ray.t_min = epsilon / length_of(direction);
      break;
    }
    break;
  case SelfHit::normal_bump:
    ray.origin = surface.point + surface.geometric_normal * (surface.back_face ? -epsilon : epsilon);
    break;
  case SelfHit::exclusion:
    ray.start = surface.primitive;
    ray.excludes_start = true;
    break;
  }
  return ray;
}

}  // namespace ps
