#pragma once
#include <array>
#include <optional>

#include "image/mip_chain.h"
#include "inspect/microscope/microscope.h"

namespace ps {

/// The texels around a lookup, level by level, with the weights that the kernel noted. `steps` is the distance that the
/// lookup moves from one pixel to the next and from one row to the next, in texels of the finest level; without it
/// there is no footprint.
MicroTexture micro_texture(const TextureEvent& lookup, const MipChain& chain, TextureWrap wrap,
                           const std::optional<std::array<Vec2d, 2>>& steps);

}  // namespace ps
