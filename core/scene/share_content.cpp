#include "scene/share_content.h"

#include <algorithm>

namespace ps {
namespace {

template <class T>
void share(std::shared_ptr<const T>& content, const std::shared_ptr<const T>& earlier) {
  if (content && earlier && *content == *earlier) content = earlier;
}

}  // namespace

Scene share_content(Scene scene, const Scene& earlier) {
  scene.geometry.edit([&](Geometry& geometry) {
    const auto& meshes = earlier.geometry->meshes;
    for (std::size_t i = 0; i < std::min(meshes.size(), geometry.meshes.size()); ++i)
      share(geometry.meshes[i], meshes[i]);
  });
  scene.textures.edit([&](std::vector<Texture>& textures) {
    for (std::size_t i = 0; i < std::min(earlier.textures->size(), textures.size()); ++i)
      share(textures[i].texels, (*earlier.textures)[i].texels);
  });
  return scene;
}

}  // namespace ps
