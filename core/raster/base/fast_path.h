#pragma once
#include "frame/frame.h"
#include "raster/setup/surface.h"
#include "scene/scene.h"

namespace ps {

/// Decides what may draw a picture of the rasterizer, and says why no faster code may.
FastPath rasterized_fast_path(const Settings& settings, const SceneTraits& traits, Channel channels);

namespace raster {

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

}  // namespace raster
}  // namespace ps
