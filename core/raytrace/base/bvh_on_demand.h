#pragma once
#include <atomic>
#include <memory>
#include <mutex>

#include "raytrace/base/geometry.h"

namespace ps {

/// The tree over all bounded primitives of a scene, built when it is first asked for. Pictures that SIMD draws search a
/// tree of their own (raytrace/fast/wide_geometry.h) and do without this one: the clear path, the inspector and rays
/// that do not suit SIMD ask for it.
template <class Real>
class BvhOnDemand {
 public:
  explicit BvhOnDemand(std::shared_ptr<const TracedGeometry<Real>> geometry) : state_(std::make_unique<State>()) {
    state_->geometry = std::move(geometry);
  }
  /// May be called by several threads: those that come while one builds wait for it. Throws Cancelled if the builder is
  /// stopped (base/stop.h); the next one begins again.
  const Bvh<Real>& tree() const {
    const Bvh<Real>* const made = state_->made.load(std::memory_order_acquire);
    return made ? *made : build();
  }
  std::size_t heap_bytes() const {
    const Bvh<Real>* const made = state_->made.load(std::memory_order_acquire);
    return sizeof(State) + (made ? owned_bytes(*made) : 0);
  }

 private:
  struct State {
    std::mutex mutex;
    std::shared_ptr<const TracedGeometry<Real>> geometry;  ///< until the tree is built
    Bvh<Real> tree;
    std::atomic<const Bvh<Real>*> made{nullptr};
  };
  const Bvh<Real>& build() const;

  std::unique_ptr<State> state_;
};

/// The product for this scene.
template <class Real>
std::shared_ptr<const BvhOnDemand<Real>>
traced_bvh(const Scene& scene, const std::shared_ptr<const TracedGeometry<Real>>& geometry, Prepared& prepared);

}  // namespace ps
