#pragma once
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "frame/prepared.h"
#include "image/image.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps::raster {

/// The surroundings of a point: six pictures that the rasterizer makes itself, in the order of cube_faces() (CGFS
/// ch. 15).
struct EnvironmentMap {
  Vec3d centre{0, 0, 0};  ///< world space
  int size = 0;           ///< pixels along an edge
  std::vector<Image<Vec3f>> faces;
  int left_out = 0;  ///< dynamic objects that it does not show, since `environment-objects` asks for static ones

  std::size_t heap_bytes() const {
    std::size_t bytes = faces.capacity() * sizeof faces[0];
    for (const auto& face : faces) bytes += face.pixels().size_bytes();
    return bytes;
  }
};

/// The map in which each object looks up its reflections; null for objects without reflections.
using EnvironmentMaps = std::vector<std::shared_ptr<const EnvironmentMap>>;

/// Is the option on, and does anything mirror?
bool uses_environment(const Settings& settings, const Scene& scene);

/// The map unfolded as a cross over the picture's area; pixels outside it stay as they are.
void lay_out_environment(const EnvironmentMap& map, Image<Vec3f>& picture);

}  // namespace ps::raster
