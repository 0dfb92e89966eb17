#include "hardware/level_atlas.h"

#include <algorithm>
#include <bit>

#include "image/image.h"

namespace ps::hardware {

// The same formula is in texturing.glsl. Level 1 takes half of the shared height, level 2 a quarter, and so on;
// what is wider than high has further levels of one row each, which follow.
Vec2i LevelAtlas::place(int level) const {
  if (level == 0) return {0, 0};
  const int shared_height = 1 << layout.z;
  return {layout.x, shared_height - (shared_height >> (level - 1)) + std::max(level - 2 - layout.z, 0)};
}

LevelAtlas atlas_of(const MipChain& chain) {
  const Image<Vec3f>& base = *chain.base;
  LevelAtlas atlas;
  const auto shared_height = std::bit_ceil(static_cast<unsigned>(base.height()));
  atlas.layout = {base.width(), base.height(), std::countr_zero(shared_height), chain.levels() - 1};
  atlas.width = base.width();
  atlas.height = base.height();
  for (int level = 1; level < chain.levels(); ++level) {
    const Vec2i at = atlas.place(level);
    atlas.width = std::max(atlas.width, at.x + chain.level(level).width());
    atlas.height = std::max(atlas.height, at.y + chain.level(level).height());
  }
  return atlas;
}

}  // namespace ps::hardware
