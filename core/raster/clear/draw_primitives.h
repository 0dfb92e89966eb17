#pragma once
#include <span>

#include "raster/assembly/bins.h"
#include "raster/base/target.h"

namespace ps::raster {

/// Draws triangles or lines into a tile, in the order given, as far as the step goes. The one kernel of the rasterizer:
/// pictures and the inspector both come from it.
template <class Real, class Recorder>
void draw_primitives(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                     std::span<const PrimitiveRef> primitives, const DrawStep& step, Target<Real>& target,
                     Recorder& recorder);

/// Deferred shading, after the tile's triangles: shades each pixel's winner once.
template <class Real, class Recorder>
void shade_winners(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry, Target<Real>& target,
                   Recorder& recorder);

}  // namespace ps::raster
