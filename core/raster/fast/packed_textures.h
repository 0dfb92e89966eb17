#pragma once
#include <memory>
#include <vector>

#include "raster/base/raster_inputs.h"
#include "raster/fast/packed_texture.h"

namespace ps::raster {

/// The textures of a picture in the form that the kernels read, in the order of the scene's.
class PackedTextures {
 public:
  /// Those of `inputs`; none where it reads none.
  PackedTextures(const RasterInputs<float>& inputs, Prepared& prepared);

  /// Null for a surface without texture, and where the texture is too large to be packed.
  const PackedTexture* of(const Surface<float>& surface) const;
  /// Is there room for what the surface reads?
  bool has_room_for(const Surface<float>& surface) const {
    return surface.layout.uv == AttributeLayout::absent || of(surface) != nullptr;
  }

 private:
  std::shared_ptr<const std::vector<PackedTexture>> textures_;
};

}  // namespace ps::raster
