#pragma once
#include <cmath>

#include "raster/base/fragment.h"
#include "raster/setup/depth_format.h"

namespace ps::raster {

/// Where a sample's ray crosses the plane one unit before the eye (perspective), or the place that a parallel ray
/// starts from: camera space. `in_pixel` is the sample's place in its pixel, from 0 to 1.
template <class Real>
inline Vec2<Real> on_projection_plane(const CanvasProjection<Real>& projection, const Fragment<Real>& fragment,
                                      const Vec2d& in_pixel) {
  const Real column = static_cast<Real>(fragment.column) + static_cast<Real>(in_pixel.x);
  const Real row = static_cast<Real>(fragment.row) + static_cast<Real>(in_pixel.y);
  return {(column - projection.centre.x) / projection.scale.x, (projection.centre.y - row) / projection.scale.y};
}

/// The value that is encoded, stored and compared (CGFS ch. 12), at the sample that lies at `in_pixel` in its pixel.
template <class Real>
inline Real depth_value(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                        const Fragment<Real>& fragment, const Vec2d& in_pixel) {
  switch (inputs.settings.depth_value) {
  case DepthValue::inverse_z:
    return fragment.inverse_z;
  case DepthValue::z:  // as if it were linear on the screen, which it is not: the book's wrong turn
    return weighted(fragment.weights, setup.triangle->z);
  case DepthValue::distance: {
    if (!inputs.perspective()) return fragment.z;
    const Vec2<Real> p = on_projection_plane(inputs.projection, fragment, in_pixel);
    return fragment.z * std::sqrt(p.x * p.x + p.y * p.y + Real(1));
  }
  case DepthValue::ray_plane: {
    const Vec2<Real> p = on_projection_plane(inputs.projection, fragment, in_pixel);
    return inputs.perspective() ? setup.plane.along_eye_ray(p.x, p.y) : setup.plane.along_parallel_ray(p.x, p.y);
  }
  }
  return 0;
}

}  // namespace ps::raster
