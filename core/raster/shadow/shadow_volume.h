#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "raster/setup/draw_list.h"
#include "scene/light.h"

namespace ps::raster {

/// An edge of the outline that an object shows to a light, in world space. The side of the shadow volume that starts
/// there has the lit triangle's vertex order reversed: it runs from `to` to `from`.
struct SilhouetteEdge {
  Vec3d from{0, 0, 0}, to{0, 0, 0};
};

/// A triangle of an object's mesh that casts its shadow.
struct LitTriangle {
  std::uint32_t triangle = 0;  ///< index into the mesh's
  bool turned = false;         ///< its back faces the light, so its copy in the volume has the other vertex order
};

/// The space that an object hides from a light, as a closed surface whose triangles face outwards (CGFS ch. 15): the
/// triangles that face the light, sides that run from the silhouette's edges away from the light, and the lit triangles
/// again at the far end, seen from behind.
struct ShadowVolume {
  int object = 0;  ///< index into Geometry::objects
  std::vector<SilhouetteEdge> silhouette;
  std::vector<LitTriangle> lit;
  /// The vertices of `surface` are those of the object, of equal ones only the first, and then the same at the far end.
  /// For each of the first half: the index of the vertex in the object's mesh.
  std::vector<std::uint32_t> source;
  /// The triangles of `surface`: lit ones and their copies at the far end in turns, or none if caps are left out; then
  /// those of the sides.
  std::size_t caps = 0;
  std::vector<std::uint32_t> edge_of_side;  ///< for each triangle after the caps, the index into `silhouette`
  std::shared_ptr<const Mesh> surface;      ///< world space
};

/// How far volumes without end reach, in units of the scene's size.
inline constexpr double volume_reach = 1e4;

/// What volumes are made like.
struct ShadowVolumeOptions {
  /// World units: how far each vertex is moved away from the light, or nullopt for a volume without end.
  std::optional<double> length{};
  double reach = 1;  ///< length of the sides of a volume without end, world units; large beside the scene
  bool caps = true;  ///< lit triangles and far end; without, the surface is open at both ends
};

/// Closed models cast shadows with the triangles that face the light. In an open one any triangle may be the only one
/// in the light's way, so all do, each turned to face the light; where two lie behind each other the count is 2, which
/// is as dark as 1. Empty for ambient light. Throws Cancelled (base/stop.h).
ShadowVolume make_shadow_volume(const DrawObject& object, const Light& light, const ShadowVolumeOptions& options);

/// Shadow volumes of all opaque objects, one list for each light, as `settings` choose.
std::vector<std::vector<ShadowVolume>> make_shadow_volumes(const Scene& scene, const std::vector<DrawObject>& objects,
                                                           const Settings& settings);

}  // namespace ps::raster
