#include "raster/fast/packed_textures.h"

namespace ps::raster {

PackedTextures::PackedTextures(const RasterInputs<float>& inputs, Prepared& prepared) {
  if (!inputs.textures) return;
  const Settings& settings = inputs.settings;
  const Key key = Key("raster-packed-textures")
                      .add(inputs.scene->textures.revision())
                      .add(std::uint64_t{reads_mip_levels(settings.texture_filter)})
                      .add(settings.texture_wrap);
  textures_ = prepared.get<std::vector<PackedTexture>>(key, [&] {
    std::vector<PackedTexture> packed;
    for (const MipChain& chain : *inputs.textures) packed.push_back(pack_texture(chain, wrap_of(chain, settings)));
    return packed;
  });
}

const PackedTexture* PackedTextures::of(const Surface<float>& surface) const {
  const int index = surface.material.texture;
  if (!textures_ || index < 0) return nullptr;
  const PackedTexture& texture = (*textures_)[static_cast<std::size_t>(index)];
  return texture.levels > 0 ? &texture : nullptr;
}

}  // namespace ps::raster
