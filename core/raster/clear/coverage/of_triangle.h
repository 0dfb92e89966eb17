#pragma once
#include "raster/base/raster_inputs.h"
#include "raster/base/screen_triangle.h"
#include "raster/clear/coverage/input.h"

namespace ps::raster {

/// A triangle as a coverage strategy is given it.
template <class Real>
CoverageInput coverage_input(const RasterInputs<Real>& inputs, const ScreenTriangle<Real>& triangle,
                             const EdgeFunctions& edges) {
  return {triangle.corners, edges, inputs.grid, triangle.box, inputs.settings.projection};
}

}  // namespace ps::raster
