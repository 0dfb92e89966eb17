#pragma once
#include "raster/clear/coverage/input.h"
#include "raster/clear/screen_triangle.h"
#include "raster/pass.h"

namespace ps::raster {

/// The samples that coverage is asked for: those of the triangle's box, or all where no box is used.
template <class Real>
TileRect tested_box(const Pass<Real>& pass, const ScreenTriangle<Real>& triangle) {
  if (pass.coverage.strategy != Coverage::ray_test) return triangle.box;
  return {0, 0, pass.viewport.columns, pass.viewport.rows};
}

template <class Real>
CoverageInput coverage_input(const Pass<Real>& pass, const ScreenTriangle<Real>& triangle, const TriangleEdges& edges) {
  return {triangle.corners, edges, pass.grid, triangle.box, pass.settings.projection};
}

}  // namespace ps::raster
