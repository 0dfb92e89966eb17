#include "hardware/shadow_volumes.h"

#include "base/stop.h"
#include "hardware/near_triangles.h"
#include "raster/shadow/shadow_volume.h"

namespace ps::hardware {
namespace {

/// Makes what the driver reads of the vertices of one volume.
class VolumeVertices {
 public:
  VolumeVertices(const PicturePlan& plan, const raster::DrawObject& object, const raster::ShadowVolume& volume,
                 const std::vector<Vec3f>& snapped, const MeshBuffers& buffers)
      : plan_(plan), object_(object), volume_(volume), snapped_(snapped), buffers_(buffers) {}

  /// A vertex of the object's mesh.
  void add_near(std::uint32_t mesh_vertex, VolumeCorners& corners) const {
    corners.places.emplace_back(Vec3f(buffers_.place(object_.mesh->positions[mesh_vertex])), 0.0f);
    if (!snapped_.empty()) corners.snapped.push_back(snapped_[mesh_vertex]);
  }
  /// A vertex of the volume's surface.
  void add(std::uint32_t vertex, VolumeCorners& corners) const {
    if (vertex < volume_.source.size()) return add_near(volume_.source[vertex], corners);
    corners.places.emplace_back(Vec3f(volume_.surface->positions[vertex] - plan_.camera.position), 1.0f);
    if (!snapped_.empty()) corners.snapped.emplace_back(0.0f);
  }

 private:
  const PicturePlan& plan_;
  const raster::DrawObject& object_;
  const raster::ShadowVolume& volume_;
  const std::vector<Vec3f>& snapped_;
  const MeshBuffers& buffers_;
};

/// Is it one of the triangles in the light, and not one of their copies or of the sides?
bool is_lit_face(const raster::ShadowVolume& volume, std::size_t triangle) {
  return triangle < volume.caps && triangle % 2 == 0;
}

/// Does the triangle of the volume's surface, with the vertex order in which it is drawn, face out of the volume? The
/// volume is that of the object.
bool faces_outwards(const raster::ShadowVolume& volume, const raster::DrawObject& object, std::size_t triangle) {
  return !is_lit_face(volume, triangle) || volume.lit[triangle / 2].turned == object.mirrored;
}

}  // namespace

std::vector<VolumeFaces> volume_faces(const PicturePlan& plan, std::size_t light,
                                      const std::vector<std::vector<Vec3f>>& snapped_of,
                                      const std::vector<const MeshBuffers*>& buffers_of) {
  std::vector<VolumeFaces> all;
  std::size_t drawn = 0;
  for (const raster::ShadowVolume& volume : (*plan.volumes)[light]) {
    check_stop();
    while (plan.objects[drawn].object != volume.object) ++drawn;
    const raster::DrawObject& object = plan.objects[drawn];
    const VolumeVertices vertices(plan, object, volume, snapped_of[drawn], *buffers_of[drawn]);
    VolumeFaces& faces = all.emplace_back();
    faces.object = drawn;
    const auto& triangles = volume.surface->triangles;
    std::vector<bool> near;
    if (plan.region) near = NearTest(plan, *plan.region).of_volume(volume);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (plan.region && !near[i]) continue;
      const bool outwards = faces_outwards(volume, object, i);
      VolumeCorners& corners = outwards ? faces.outwards : faces.inwards;
      (outwards ? faces.outward_numbers : faces.inward_numbers).push_back(static_cast<std::uint32_t>(i));
      if (is_lit_face(volume, i))
        for (const std::uint32_t vertex : object.mesh->triangles[volume.lit[i / 2].triangle].position)
          vertices.add_near(vertex, corners);
      else
        for (const std::uint32_t vertex : triangles[i].position) vertices.add(vertex, corners);
    }
  }
  return all;
}

}  // namespace ps::hardware
