#pragma once
#include "accel/bounding_spheres.h"
#include "accel/octree.h"
#include "accel/single_box.h"
#include "base/machine.h"
#include "raytrace/embree_triangles.h"
#include "raytrace/two_level.h"

namespace ps {

/// Whether the BVH is used: by choice, or instead of Embree, which has no double precision and may be missing.
template <class Real>
bool uses_bvh(const Settings& settings) {
  const bool embree = std::is_same_v<Real, float> && has_embree();
  return settings.accelerator == Accelerator::bvh || (settings.accelerator == Accelerator::embree && !embree);
}

/// The accelerator that `settings` name, unless it is the tree of boxes (traced_bvh) or none; at most one is there.
template <class Real>
struct SimpleAccelerators {
  std::shared_ptr<const BoundingSpheres> spheres;
  std::shared_ptr<const SingleBox<Real>> box;
  std::shared_ptr<const Octree<Real>> octree;
  std::shared_ptr<const TwoLevel<Real>> two_level;
  std::shared_ptr<const EmbreeGeometry> embree;  ///< in float only
  bool any() const { return spheres || box || octree || two_level || embree; }
};

template <class Real>
SimpleAccelerators<Real> simple_accelerators(const Scene& scene, const TracedGeometry<Real>& geometry,
                                             const Settings& settings, Prepared& prepared);

/// The triangles of `octree`, which simple_accelerators() made with these settings, as the SIMD queries search them.
std::shared_ptr<const WideGeometry> wide_octree_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                         const Octree<float>& octree, const Settings& settings,
                                                         Prepared& prepared);

}  // namespace ps
