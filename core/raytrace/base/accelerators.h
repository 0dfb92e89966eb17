#pragma once
#include <memory>
#include <type_traits>
#include <variant>

#include "accel/bounding_spheres.h"
#include "accel/none.h"
#include "accel/octree.h"
#include "accel/single_box.h"
#include "base/machine.h"
#include "raytrace/base/bvh_on_demand.h"
#include "raytrace/base/embree_triangles.h"
#include "raytrace/base/two_level.h"

namespace ps {

/// Whether the BVH is used: by choice, or instead of Embree, which has no double precision and may be missing.
template <class Real>
bool uses_bvh(const Settings& settings) {
  const bool embree = std::is_same_v<Real, float> && has_embree();
  return settings.accelerator == Accelerator::bvh || (settings.accelerator == Accelerator::embree && !embree);
}

/// What narrows down the primitives that a ray may meet. Each holds those that are bounded, NoAccelerator all.
template <class Real>
using TracedAccelerator =
    std::variant<NoAccelerator, std::shared_ptr<const SingleBox<Real>>, std::shared_ptr<const BoundingSpheres>,
                 std::shared_ptr<const BvhOnDemand<Real>>, std::shared_ptr<const Octree<Real>>,
                 std::shared_ptr<const TwoLevel<Real>>, std::shared_ptr<const EmbreeGeometry<Real>>>;

/// The one that `settings` name; where Embree cannot be used (uses_bvh()), the tree of boxes.
template <class Real>
TracedAccelerator<Real> traced_accelerator(const Scene& scene,
                                           const std::shared_ptr<const TracedGeometry<Real>>& geometry,
                                           const Settings& settings, Prepared& prepared);

/// The accelerator if it is of this type, such as Octree<float>; null otherwise.
template <class Type, class Accelerator>
const Type* accelerator_as(const Accelerator& accelerator) {
  const auto* found = std::get_if<std::shared_ptr<const Type>>(&accelerator);
  return found ? found->get() : nullptr;
}

}  // namespace ps
