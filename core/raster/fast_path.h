#pragma once
#include "frame/frame.h"
#include "raster/setup/surface.h"

namespace ps::raster {

/// Do the SIMD kernels shade such a surface? Where rasterized_fast_path() says SurfaceShading::lanes, they do every
/// one.
bool shades_in_lanes(const Surface<float>& surface);

/// What is in the way of whole tiles besides settings, scene and channels.
struct PictureLimits {
  bool part_only = false;       ///< a part of the picture is asked for
  bool large_textures = false;  ///< a texture does not fit the kernels' form
};

/// What draws the picture where rasterized_fast_path() said `allowed`.
FastPath within_limits(const FastPath& allowed, const PictureLimits& limits);

}  // namespace ps::raster
