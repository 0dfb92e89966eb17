#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "hardware/mesh_buffers.h"
#include "hardware/picture_plan.h"
#include "math/vec.h"

namespace ps::hardware {

/// Corners of the faces of a shadow volume as volume_vertex.glsl reads them, three for each triangle.
struct VolumeCorners {
  std::vector<Vec4f> places;
  std::vector<Vec3f> snapped;  ///< positions on the canvas that the processor has rounded; empty without
};

/// A shadow volume in two lists: triangles whose vertex order faces out of it, and others. Lit triangles keep the order
/// in which the picture's own are drawn, so that a driver interpolates the same depth across both.
struct VolumeFaces {
  std::size_t object = 0;  ///< index into PicturePlan::objects
  VolumeCorners outwards, inwards;
  std::vector<std::uint32_t> outward_numbers, inward_numbers;  ///< of the triangles in the volume's surface
};

/// The volumes of one light; where the plan is about a region, only what may reach it. `snapped_of[o][i]` is the
/// rounded position of vertex i of object o, where the processor rounds. `buffers_of` holds the meshes of the objects.
std::vector<VolumeFaces> volume_faces(const PicturePlan& plan, std::size_t light,
                                      const std::vector<std::vector<Vec3f>>& snapped_of,
                                      const std::vector<const MeshBuffers*>& buffers_of);

}  // namespace ps::hardware
