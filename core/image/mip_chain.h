#pragma once
#include <memory>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// A texture with its smaller versions (CGFS ch. 14): level 0 is the texture itself, each further level has half the
/// width and height, rounded down but at least 1, down to 1 x 1.
struct MipChain {
  std::shared_ptr<const Image<Vec3f>> base;  ///< level 0, shared with the texture
  std::vector<Image<Vec3f>> reduced;         ///< levels 1, 2, ...
  bool clamped = false;                      ///< see Texture::clamped

  /// Bytes of the smaller versions; level 0 belongs to the texture.
  std::size_t heap_bytes() const {
    std::size_t bytes = reduced.capacity() * sizeof(Image<Vec3f>);
    for (const Image<Vec3f>& image : reduced) bytes += image.pixels().size_bytes();
    return bytes;
  }
  int levels() const { return 1 + static_cast<int>(reduced.size()); }
  const Image<Vec3f>& level(int index) const {
    return index == 0 ? *base : reduced[static_cast<std::size_t>(index - 1)];
  }
};

enum class MipLevels { all, finest_only };

/// Builds the chain; `finest_only` keeps just level 0, for filters that read no other. Each texel of a level is the
/// mean of the area that it covers in the level above it, also where a size is odd, so every level has the same mean.
/// `base` must not be empty.
MipChain make_mip_chain(std::shared_ptr<const Image<Vec3f>> base, MipLevels levels = MipLevels::all);

}  // namespace ps
