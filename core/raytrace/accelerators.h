#pragma once
#include "accel/bounding_spheres.h"
#include "accel/octree.h"
#include "accel/single_box.h"
#include "raytrace/geometry.h"

namespace ps {

/// The accelerator that `settings` name, unless it is the tree of boxes (traced_bvh) or none; at most one is there.
template <class Real>
struct SimpleAccelerators {
  std::shared_ptr<const BoundingSpheres> spheres;
  std::shared_ptr<const SingleBox<Real>> box;
  std::shared_ptr<const Octree<Real>> octree;
  bool any() const { return spheres || box || octree; }
};

template <class Real>
SimpleAccelerators<Real> simple_accelerators(const Scene& scene, const TracedGeometry<Real>& geometry,
                                             const Settings& settings, Prepared& prepared);

}  // namespace ps
