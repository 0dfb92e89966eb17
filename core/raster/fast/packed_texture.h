#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/memory_size.h"
#include "image/mip_chain.h"
#include "options/settings.h"

namespace ps::raster {

/// 1 / 255 in two parts; a byte times the first is exact.
inline constexpr std::array<float, 2> byte_unit{0x1.01p-8f, 0x1.010102p-24f};

/// A mip chain in one piece of memory, as the fast path reads it. Each row of a level is longer than the level by a
/// texel at either end, those that wrapping puts there.
struct PackedTexture {
  static constexpr std::size_t most_levels = 32;
  static constexpr int most_texels = 1 << 22;  ///< along an edge, less one
  std::vector<float> texels;                   ///< red, green, blue and a zero of each texel, level after level
  /// Instead of `texels`, for a chain of one level that comes from a picture with 8 bits for each channel: one number
  /// for each texel, with red in its lowest byte, then green and blue. A quarter of the memory.
  std::vector<std::uint32_t> bytes;
  std::array<std::int32_t, most_levels> first{};   ///< index of the first number of each level's texel (0, 0)
  std::array<std::int32_t, most_levels> width{};   ///< of each level, in texels
  std::array<std::int32_t, most_levels> height{};  ///< of each level
  int levels = 0;

  std::size_t heap_bytes() const { return owned_bytes(texels, bytes); }
};

/// The fraction of 1 that byte `level` encodes. Two products and a sum are quicker than the division, and the same to
/// the last bit.
constexpr float part_of_255(float level) { return level * byte_unit[0] + level * byte_unit[1]; }

/// Nothing is packed (levels = 0) of a chain too large for 32-bit indices, or of most_texels along an edge.
PackedTexture pack_texture(const MipChain& chain, TextureWrap wrap);

/// How a batch of fragments reads a texture.
struct BatchTexture {
  const PackedTexture* texture = nullptr;  ///< nullptr = none
  TextureFilter filter = TextureFilter::trilinear;
  TextureWrap wrap = TextureWrap::repeat;
  int uv = 0;  ///< first scalar of the coordinates in the layout
  float mip_bias = 0;
  // What uv_derivatives() finds out that is the same for the whole triangle, along x and along y.
  struct Step {
    float u = 0, v = 0;   ///< change of u / z and v / z
    float inverse_z = 0;  ///< change of 1 / z
  };
  std::array<Step, 2> steps{};
};

}  // namespace ps::raster
