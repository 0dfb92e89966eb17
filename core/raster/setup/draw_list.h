#pragma once
#include <memory>
#include <vector>

#include "frame/prepared.h"
#include "frame/view.h"
#include "frame/viewport.h"
#include "math/unit.h"
#include "raster/setup/mesh_corners.h"
#include "scene/scene.h"

namespace ps::raster {

/// An object of the scene as triangles: an instance of a model, or a sphere or solid made of triangles for this view.
struct DrawObject {
  int object = 0;                              ///< index into Geometry::objects
  std::shared_ptr<const Mesh> mesh;            ///< in model space; tessellated spheres and solids are in world space
  std::shared_ptr<const MeshCorners> corners;  ///< of `mesh`
  bool sphere = false;                         ///< tessellated here: its triangles have no numbers of their own
  bool front_only = false;                     ///< backs are not drawn, whatever backface-culling says
  bool mirrored = false;                       ///< fronts are where vertices run clockwise (scene/world.h)
  Mat3d linear{1.0};                           ///< model to world, for positions: rotation * scale
  Mat3d normal_matrix{1.0};                    ///< model to world, for normals, as `normal-transform` asks
  Vec3d translation{0, 0, 0};                  ///< world units
  BoundingSphere bounds;                       ///< world space
  /// For each material slot of the mesh the index into Scene::materials; one slot for spheres and overrides.
  std::vector<std::uint32_t> materials;

  Vec3d world(const Vec3d& model) const { return linear * model + translation; }
  /// The mesh's normal of that number, in world space, length 1.
  Vec3d world_normal(std::size_t number) const { return unit_or_zero(normal_matrix * mesh->normals[number]); }
  std::uint32_t material(const MeshTriangle& triangle) const {
    return materials[materials.size() == 1 ? 0 : triangle.material];
  }
};

/// All objects in scene order. Tessellations and bounding spheres are cached in `prepared`.
std::vector<DrawObject> make_draw_list(const Scene& scene, const View& view, const Settings& settings,
                                       const Viewport<double>& viewport, Prepared& prepared);

}  // namespace ps::raster
