#pragma once
#include <cstdint>
#include <vector>

#include "accel/candidate_ray.h"
#include "base/memory_size.h"
#include "record/recorder.h"

namespace ps {

/// One box around everything: rays that miss it are done at once, all others test every primitive.
template <class Real>
struct SingleBox {
  Box<Real> box;
  std::vector<std::uint32_t> primitives;
  std::size_t heap_bytes() const { return owned_bytes(primitives); }
};

/// The accelerator interface (accel/none.h).
template <class Real, class Visit, class Recorder>
void for_each_candidate(const SingleBox<Real>& all, const CandidateRay<Real>& ray, const Real& limit, Visit&& visit,
                        Recorder& recorder) {
  if (all.primitives.empty()) return;
  const bool entered = slab_test(ray.slabs(), all.box, limit).hit();
  recorder.count(Counter::node_visits);
  recorder.event([&] { return NodeEvent{0, 0, Vec3d(all.box.low), Vec3d(all.box.high), entered}; });
  if (!entered) return;
  for (const std::uint32_t primitive : all.primitives)
    if (visit(primitive)) return;
}

}  // namespace ps
