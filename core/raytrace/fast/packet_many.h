#pragma once
#include <span>

#include "raytrace/fast/packet.h"
#include "raytrace/sampling/plan.h"

namespace ps {

/// trace_many() for these pixels by the fast path: the same rays, added up in the same order, to the same bits. Stores
/// colours, and ids and depths where the frame has them.
void trace_many_packets(const PacketScene& scene, TraceSamples trace, const SamplingPlan& plan,
                        std::span<const Vec2i> pixels, Frame& frame, Counters& counters);

}  // namespace ps
