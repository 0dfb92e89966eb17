#include "raster/fast/packed_texture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace ps::raster {
namespace {

constexpr bool parts_are_quotients() {
  for (int level = 0; level < 256; ++level)
    if (part_of_255(static_cast<float>(level)) != static_cast<float>(level) / 255) return false;
  return true;
}
static_assert(parts_are_quotients());

/// The texel as PackedTexture::bytes holds it, or nullopt where some channel is not part_of_255() of a byte.
std::optional<std::uint32_t> texel_bytes(const Vec3f& texel) {
  std::uint32_t bytes = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const float value = texel[channel];
    if (!(value >= 0 && value <= 1) || std::signbit(value)) return std::nullopt;
    const float level = std::nearbyint(value * 255);
    if (part_of_255(level) != value) return std::nullopt;
    bytes |= static_cast<std::uint32_t>(level) << (8 * channel);
  }
  return bytes;
}

/// The texels of a row with the two that wrapping adds.
template <class Add>
void add_row(std::span<const Vec3f> row, TextureWrap wrap, Add&& add) {
  const bool around = wrap == TextureWrap::repeat;
  add(around ? row.back() : row.front());
  for (const Vec3f& texel : row) add(texel);
  add(around ? row.front() : row.back());
}

/// Fills PackedTexture::bytes where the picture fits them.
bool pack_bytes(const Image<Vec3f>& image, TextureWrap wrap, PackedTexture& packed) {
  packed.bytes.reserve(static_cast<std::size_t>(image.width() + 2) * static_cast<std::size_t>(image.height()));
  bool fits = true;
  for (int y = 0; y < image.height() && fits; ++y)
    add_row(image.row(y), wrap, [&](const Vec3f& texel) {
      const std::optional<std::uint32_t> bytes = texel_bytes(texel);
      fits = fits && bytes;
      packed.bytes.push_back(bytes.value_or(0));
    });
  if (fits) return true;
  packed.bytes = {};
  return false;
}

}  // namespace

PackedTexture pack_texture(const MipChain& chain, TextureWrap wrap) {
  PackedTexture packed;
  constexpr std::size_t values_per_texel = 4;
  std::size_t total = 0;
  for (int level = 0; level < chain.levels(); ++level)
    total += static_cast<std::size_t>(chain.level(level).width() + 2) *
             static_cast<std::size_t>(chain.level(level).height()) * values_per_texel;
  const auto levels = static_cast<std::size_t>(chain.levels());
  if (total > std::size_t{std::numeric_limits<std::int32_t>::max()} || levels > PackedTexture::most_levels ||
      std::max(chain.base->width(), chain.base->height()) >= PackedTexture::most_texels)
    return packed;
  for (std::size_t i = 0; i < levels; ++i) {
    packed.width[i] = chain.level(static_cast<int>(i)).width();
    packed.height[i] = chain.level(static_cast<int>(i)).height();
  }
  packed.levels = chain.levels();
  if (levels == 1 && pack_bytes(chain.level(0), wrap, packed)) {
    packed.first[0] = 1;
    return packed;
  }
  packed.texels.reserve(total);
  for (std::size_t i = 0; i < levels; ++i) {
    const Image<Vec3f>& image = chain.level(static_cast<int>(i));
    packed.first[i] = static_cast<std::int32_t>(packed.texels.size() + values_per_texel);
    for (int y = 0; y < image.height(); ++y)
      add_row(image.row(y), wrap, [&](const Vec3f& texel) {
        packed.texels.insert(packed.texels.end(), {texel.x, texel.y, texel.z, 0.0f});
      });
  }
  return packed;
}

}  // namespace ps::raster
