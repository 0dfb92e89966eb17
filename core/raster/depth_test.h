#pragma once
#include <cmath>

#include "raster/depth_format.h"
#include "raster/fragment.h"

namespace ps::raster {

/// The value that is encoded, stored and compared (CGFS ch. 12).
template <class Real>
inline Real depth_value(const Pass<Real>& pass, const TriangleSetup<Real>& setup, const Fragment<Real>& fragment) {
  switch (pass.settings.depth_value) {
  case DepthValue::inverse_z:
    return fragment.inverse_z;
  case DepthValue::z:  // as if it were linear on the screen, which it is not: the book's wrong turn
    return weighted(fragment.weights, setup.triangle->z);
  case DepthValue::distance: {
    if (!pass.perspective()) return fragment.z;
    const CanvasProjection<Real>& projection = pass.projection;
    const Real column = static_cast<Real>(fragment.column) + static_cast<Real>(pass.grid.sample.x);
    const Real row = static_cast<Real>(fragment.row) + static_cast<Real>(pass.grid.sample.y);
    const Real x = (column - projection.centre.x) / projection.scale.x;
    const Real y = (projection.centre.y - row) / projection.scale.y;
    return fragment.z * std::sqrt(x * x + y * y + Real(1));
  }
  }
  return 0;
}

}  // namespace ps::raster
