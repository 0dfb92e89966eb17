#pragma once
#include "raytrace/base/ray.h"
#include "raytrace/base/trace_inputs.h"

namespace ps {

/// Turns an eye ray to the viewport position x to the right of the centre and `upwards` (world space) above it.
template <class Real>
inline void aim(const TraceInputs<Real>& inputs, Ray<Real>& ray, Real x, const Vec3<Real>& upwards) {
  const Vec3<Real> across = inputs.right * x + upwards;
  switch (inputs.viewport.projection) {
  case Projection::perspective:
    ray.direction = across + inputs.forward;
    break;
  case Projection::orthographic:
    ray.origin = inputs.eye + across;
    break;
  }
}

/// An eye ray that is aimed there.
template <class Real>
inline Ray<Real> eye_ray_to(const TraceInputs<Real>& inputs, Real x, const Vec3<Real>& upwards) {
  Ray<Real> ray{inputs.eye, inputs.forward, inputs.near, inputs.far, no_primitive};
  aim(inputs, ray, x, upwards);
  return ray;
}

/// The ray through a point of pixel (column, row), `offset` from its top-left corner (CGFS ch. 2).
template <class Real>
inline Ray<Real> eye_ray(const TraceInputs<Real>& inputs, int column, int row, const Vec2d& offset) {
  const Vec2<Real> v = inputs.viewport.at(column, row, offset);
  return eye_ray_to(inputs, v.x, inputs.up * v.y);
}

}  // namespace ps
