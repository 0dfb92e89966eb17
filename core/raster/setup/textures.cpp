#include "raster/setup/textures.h"

namespace ps::raster {

std::shared_ptr<const std::vector<MipChain>> mip_chains(const Scene& scene, TextureFilter filter, Prepared& prepared) {
  using Textures = std::vector<MipChain>;
  const MipLevels which = reads_mip_levels(filter) ? MipLevels::all : MipLevels::finest_only;
  return prepared.get<Textures>(Key("raster-textures").add(scene.textures.revision()).add(which), [&] {
    Textures chains;
    for (const Texture& texture : *scene.textures) {
      chains.push_back(make_mip_chain(texture.texels, which));
      chains.back().clamped = texture.clamped;
    }
    return chains;
  });
}

}  // namespace ps::raster
