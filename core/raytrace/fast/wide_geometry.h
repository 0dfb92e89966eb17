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
/// Chooses from where a tree and `others` are seen (seen_from()), and turns the tree's nodes to it.
SeenFrom<float> see_from_well(LargeArray<WideNode>& nodes, const Bvh<float>& others,
                              const TracedGeometry<float>& traced);

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
