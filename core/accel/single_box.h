#pragma once
#include <cstdint>

#include "accel/candidate_ray.h"
#include "inspect/recorder.h"

namespace ps {

/// One box around everything: rays that miss it are done at once, all others test every primitive.
template <class Real>
struct SingleBox {
  Box<Real> box;
  std::uint32_t count = 0;  ///< primitives 0 .. count - 1
};

/// The accelerator interface (accel/none.h).
template <class Real, class Visit, class Recorder>
void for_each_candidate(const SingleBox<Real>& all, const CandidateRay<Real>& ray, const Real& limit, Visit&& visit,
                        Recorder& recorder) {
  if (all.count == 0) return;
  const bool entered = slab_test(ray.slabs, all.box, limit).hit();
  recorder.count(Counter::node_visits);
  recorder.event([&] { return NodeEvent{0, 0, Vec3d(all.box.low), Vec3d(all.box.high), entered}; });
  for (std::uint32_t primitive = 0; entered && primitive < all.count; ++primitive)
    if (visit(primitive)) return;
}

}  // namespace ps
