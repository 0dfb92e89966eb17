#pragma once
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "frame/prepared.h"
#include "image/image.h"
#include "options/settings.h"
#include "raster/setup/draw_list.h"
#include "raster/shadow/cube_face.h"
#include "scene/scene.h"

namespace ps::raster {

/// What one light sees (CGFS ch. 15, CGPP 15.6.5): for each texel the depth of the nearest surface, +infinity where
/// there is none. A point light has the six faces of a cube around it; a directional one has a single square.
struct ShadowMap {
  int size = 0;  ///< texels along an edge; 0 = the light casts no shadows
  bool cube = false;
  std::vector<Image<float>> faces;  ///< depth along the face's forward axis
  Vec3d position{0, 0, 0};          ///< world space: the light, or where depth is 0 at the centre of the square
  CubeFace frame{};                 ///< of the square
  double half = 0;                  ///< half the side of the square, world units

  std::size_t heap_bytes() const {
    std::size_t bytes = faces.capacity() * sizeof faces[0];
    for (const auto& face : faces) bytes += face.pixels().size_bytes();
    return bytes;
  }
};

/// One for each light of the scene, in its order.
using ShadowMaps = std::vector<ShadowMap>;

/// Bytes that the maps of these lights take with `size` texels along an edge, and that drawing one of them takes
/// beside.
std::uint64_t shadow_map_bytes(const std::vector<Light>& lights, int size);

/// Is the object in the way of light? Not if it is transparent (as for rays), or has no triangles (CSG).
bool throws_shadow(const Scene& scene, const Object& object);

/// Is the option on, and is there light to block?
bool uses_shadow_maps(const Settings& settings, const Scene& scene);

/// All objects but those that dwarf the rest, such as a ground, so that a map spends its texels where shadows begin:
/// along a directional light a shadow lies straight behind its object, so nothing that is beside these can be in their
/// shadow. Much larger objects cast shadows into a map only from behind its nearest of them.
struct ShadowCasters {
  Vec3d centre{0, 0, 0};  ///< of a ball around them, world space
  double radius = 1;      ///< of that ball
  std::vector<DrawObject> objects;
};
ShadowCasters shadow_casters(const Scene& scene);

/// Where a directional light's map lies, without its depths.
ShadowMap empty_directional_map(const Scene& scene, const Light& light, int size);

}  // namespace ps::raster
