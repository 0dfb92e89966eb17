#include "raster/packed_texture.h"

#include <limits>

namespace ps::raster {

PackedTexture pack_texture(const MipChain& chain) {
  PackedTexture packed;
  std::size_t total = 0;
  for (int level = 0; level < chain.levels(); ++level) total += chain.level(level).pixels().size() * 3;
  const auto levels = static_cast<std::size_t>(chain.levels());
  if (total > std::size_t{std::numeric_limits<std::int32_t>::max()} || levels > PackedTexture::most_levels)
    return packed;
  packed.texels.reserve(total + 1);
  for (std::size_t i = 0; i < levels; ++i) {
    const Image<Vec3f>& image = chain.level(static_cast<int>(i));
    packed.first[i] = static_cast<std::int32_t>(packed.texels.size());
    packed.width[i] = image.width();
    packed.height[i] = image.height();
    for (const Vec3f& texel : image.pixels()) packed.texels.insert(packed.texels.end(), {texel.x, texel.y, texel.z});
  }
  packed.texels.push_back(0);
  packed.levels = chain.levels();
  return packed;
}

}  // namespace ps::raster
