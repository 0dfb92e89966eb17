#include "raster/packed_texture.h"

#include <limits>

namespace ps::raster {

PackedTexture pack_texture(const MipChain& chain, TextureWrap wrap) {
  PackedTexture packed;
  constexpr std::size_t four = 4;
  std::size_t total = 0;
  for (int level = 0; level < chain.levels(); ++level)
    total += static_cast<std::size_t>(chain.level(level).width() + 2) *
             static_cast<std::size_t>(chain.level(level).height()) * four;
  const auto levels = static_cast<std::size_t>(chain.levels());
  if (total > std::size_t{std::numeric_limits<std::int32_t>::max()} || levels > PackedTexture::most_levels)
    return packed;
  packed.texels.reserve(total);
  const auto add = [&](const Vec3f& texel) {
    packed.texels.insert(packed.texels.end(), {texel.x, texel.y, texel.z, 0.0f});
  };
  const bool around = wrap == TextureWrap::repeat;
  for (std::size_t i = 0; i < levels; ++i) {
    const Image<Vec3f>& image = chain.level(static_cast<int>(i));
    packed.first[i] = static_cast<std::int32_t>(packed.texels.size() + four);
    packed.width[i] = image.width();
    packed.height[i] = image.height();
    for (int y = 0; y < image.height(); ++y) {
      const auto row = image.row(y);
      add(around ? row.back() : row.front());
      for (const Vec3f& texel : row) add(texel);
      add(around ? row.front() : row.back());
    }
  }
  packed.levels = chain.levels();
  return packed;
}

}  // namespace ps::raster
