#pragma once
#include <memory>
#include <vector>

#include "accel/octree.h"
#include "accel/wide_bvh.h"
#include "raytrace/base/geometry.h"

namespace ps {

/// What the SIMD queries search: the triangles in a tree eight wide; everything else in a tree of its own.
struct WideGeometry {
  WideBvh triangles;
  Bvh<float> others;  ///< its order holds numbers of primitives
  float reach = 0;    ///< the largest coordinate of the boxes of both, as seen from triangles.centre

  std::size_t heap_bytes() const { return owned_bytes(triangles, others); }
};
/// The point from which boxes are seen, and the largest coordinate of their contents as seen from there.
struct SeenFrom {
  Vec3f centre{0};
  float reach = 0;
};
/// Chooses it for a tree and `others`, and turns the tree's nodes to it. Boxes are grown by some rounding errors of the
/// coordinates, so that none turns away what a test accepts. The tests of triangles and spheres begin with differences
/// between the primitive's numbers and the ray's origin: it makes no difference to them where in the world both are. If
/// the scene lies far from the world's origin for its size, errors of the world's coordinates would be larger than its
/// boxes, and reject nothing. Solids keep the world's: their tests may begin otherwise.
SeenFrom see_from_well(LargeArray<WideNode>& nodes, const Bvh<float>& others, const TracedGeometry<float>& traced);

/// The tree of boxes.
std::shared_ptr<const WideGeometry> wide_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                  Prepared& prepared);
/// The triangles of `octree`, which traced_accelerator() made with these settings.
std::shared_ptr<const WideGeometry> wide_octree_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                         const Octree<float>& octree, const Settings& settings,
                                                         Prepared& prepared);

/// The same without trees.
struct ListGeometry {
  TriangleList triangles;
  std::vector<std::uint32_t> others;

  std::size_t heap_bytes() const { return owned_bytes(triangles, others); }
};
std::shared_ptr<const ListGeometry> list_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                  Prepared& prepared);

}  // namespace ps
