#pragma once
#include <cstdint>

#include "accel/candidate_ray.h"

namespace ps {

/// The accelerator interface, in its simplest form: no acceleration.
///
/// for_each_candidate(accelerator, ray, limit, visit, recorder) calls visit(primitive) -> bool for every primitive
/// whose surface the ray may meet at 0 <= t <= limit, and possibly for others; `limit` is read again before each step,
/// so a visitor that shrinks it prunes the rest. It ends as soon as a visit returns true. Which primitives are visited,
/// and in which order, must not matter to the visitor's result.
struct NoAccelerator {
  std::uint32_t count = 0;  ///< primitives 0 .. count - 1
};

template <class Real, class Visit, class Recorder>
inline void for_each_candidate(const NoAccelerator& all, const CandidateRay<Real>&, const Real&, Visit&& visit,
                               Recorder&) {
  for (std::uint32_t primitive = 0; primitive < all.count; ++primitive)
    if (visit(primitive)) return;
}

}  // namespace ps
