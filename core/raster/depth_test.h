#pragma once
#include <cmath>
#include <limits>

#include "raster/fragment.h"

namespace ps::raster {

/// What the depth buffer holds where nothing was drawn: farther than everything.
template <class Real>
inline Real empty_depth(DepthValue value) {
  return value == DepthValue::inverse_z ? -std::numeric_limits<Real>::infinity()
                                        : std::numeric_limits<Real>::infinity();
}

/// Whether a fragment lies before what is stored. Equal is not nearer: the first triangle drawn, which has the lowest
/// index, keeps the pixel.
template <class Real>
inline bool is_nearer(DepthValue value, Real depth, Real stored) {
  return value == DepthValue::inverse_z ? depth > stored : depth < stored;
}

/// The value that is stored and compared (CGFS ch. 12).
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
