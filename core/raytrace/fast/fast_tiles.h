#pragma once
#include "raytrace/base/tile_tracer.h"

namespace ps {

/// The fast path that traced_fast_path() allows (TraceInputs::path), or null: then the clear path draws. `inputs` must
/// stay.
std::unique_ptr<TileTracer> fast_tiles(const Scene& scene, const TraceInputs<float>& inputs, const SamplingPlan& plan,
                                       Prepared& prepared);

/// Packets of rays against spheres (fast/packet.h), for Machinery::sphere_packets; null where numbers
/// leave the range of their arithmetic.
std::unique_ptr<TileTracer> sphere_tiles(const TraceInputs<float>& inputs, const SamplingPlan& plan);
/// SIMD searches for triangles (fast/fast_intersector.h), for Machinery::wide_triangles; null where there are none.
std::unique_ptr<TileTracer> wide_tiles(const Scene& scene, const TraceInputs<float>& inputs, const SamplingPlan& plan,
                                       Prepared& prepared);

}  // namespace ps
