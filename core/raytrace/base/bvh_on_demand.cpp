#include "raytrace/base/bvh_on_demand.h"

#include <numeric>

namespace ps {
namespace {

template <class Real>
Bvh<Real> tree_of_all(const TracedGeometry<Real>& geometry) {
  if (!geometry.unbounded.empty()) return tree_over(geometry, geometry.bounded);
  std::vector<std::uint32_t> all(geometry.primitives.size());
  std::iota(all.begin(), all.end(), 0u);
  return tree_over(geometry, all);
}

}  // namespace

template <class Real>
const Bvh<Real>& BvhOnDemand<Real>::build() const {
  const std::lock_guard lock(state_->mutex);
  if (!state_->made.load(std::memory_order_relaxed)) {
    state_->tree = tree_of_all(*state_->geometry);
    state_->geometry.reset();
    state_->made.store(&state_->tree, std::memory_order_release);
  }
  return state_->tree;
}

template <class Real>
std::shared_ptr<const BvhOnDemand<Real>>
traced_bvh(const Scene& scene, const std::shared_ptr<const TracedGeometry<Real>>& geometry, Prepared& prepared) {
  Key key("traced bvh");
  key.add(scene.geometry.revision()).add(std::uint64_t{sizeof(Real)});
  return prepared.get<BvhOnDemand<Real>>(key, [&] { return BvhOnDemand<Real>(geometry); });
}

template class BvhOnDemand<float>;
template class BvhOnDemand<double>;
template std::shared_ptr<const BvhOnDemand<float>>
traced_bvh(const Scene&, const std::shared_ptr<const TracedGeometry<float>>&, Prepared&);
template std::shared_ptr<const BvhOnDemand<double>>
traced_bvh(const Scene&, const std::shared_ptr<const TracedGeometry<double>>&, Prepared&);

}  // namespace ps
