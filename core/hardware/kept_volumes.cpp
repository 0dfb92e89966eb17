#include "hardware/kept_volumes.h"

#include <cstdint>

#include "raster/shadow/shadow_volume.h"

namespace ps::hardware {
namespace {

/// With the meshes that they are made from: as long as those are there, their addresses are theirs alone.
struct KeptVolumes {
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<std::vector<raster::ShadowVolume>> by_light;

  std::size_t heap_bytes() const {
    std::size_t bytes = meshes.capacity() * sizeof(meshes[0]);  // those belong to the scene
    for (const auto& volumes : by_light)
      for (const raster::ShadowVolume& volume : volumes)
        bytes += sizeof volume + owned_bytes(volume.silhouette, volume.lit, volume.source, volume.edge_of_side,
                                             volume.surface->positions, volume.surface->triangles);
    return bytes;
  }
};

}  // namespace

std::shared_ptr<const std::vector<std::vector<raster::ShadowVolume>>> kept_volumes(const PicturePlan& plan,
                                                                                   Prepared& prepared) {
  Key key("hardware-shadow-volumes");
  key.add(plan.scene->revision()).add(plan.settings.volume_length).add(std::uint64_t{plan.settings.volume_caps});
  for (const raster::DrawObject& object : plan.objects)
    key.add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(object.mesh.get())));
  auto kept = prepared.get<KeptVolumes>(key, [&] {
    KeptVolumes volumes;
    for (const raster::DrawObject& object : plan.objects) volumes.meshes.push_back(object.mesh);
    volumes.by_light = raster::make_shadow_volumes(*plan.scene, plan.objects, plan.settings);
    return volumes;
  });
  return {kept, &kept->by_light};
}

}  // namespace ps::hardware
