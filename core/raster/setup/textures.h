#pragma once
#include <memory>
#include <vector>

#include "frame/prepared.h"
#include "image/mip_chain.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps::raster {

/// Does the filter read more levels of a texture than the finest?
inline bool reads_mip_levels(TextureFilter filter) {
  return filter == TextureFilter::trilinear || filter == TextureFilter::mipmap;
}

/// The textures of the scene, in its order, with the levels that the filter reads. Cached in `prepared`.
std::shared_ptr<const std::vector<MipChain>> mip_chains(const Scene& scene, TextureFilter filter, Prepared& prepared);

/// What lies beyond the borders of a texture.
inline TextureWrap wrap_of(const MipChain& chain, const Settings& settings) {
  return chain.clamped ? TextureWrap::clamp : settings.texture_wrap;
}

}  // namespace ps::raster
