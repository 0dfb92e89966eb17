#pragma once
#include "raster/base/pass.h"
#include "raster/base/screen_triangle.h"
#include "raster/clear/coverage/input.h"

namespace ps::raster {

/// A triangle as a coverage strategy is given it.
template <class Real>
CoverageInput coverage_input(const Pass<Real>& pass, const ScreenTriangle<Real>& triangle, const TriangleEdges& edges) {
  return {triangle.corners, edges, pass.grid, triangle.box, pass.settings.projection};
}

}  // namespace ps::raster
