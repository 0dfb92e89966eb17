#pragma once
#include "image/mip_chain.h"
#include "math/vec.h"

namespace ps::hardware {

/// All levels of a texture in one picture: level 0 on the left, the others below each other on its right. The height
/// that they share is rounded up to a power of two, so that each level's place follows from its number.
struct LevelAtlas {
  int width = 0, height = 0;     ///< of the picture
  Vec4<int> layout{0, 0, 0, 0};  ///< as texturing.glsl reads it

  Vec2i place(int level) const;
};
LevelAtlas atlas_of(const MipChain& chain);

}  // namespace ps::hardware
