#pragma once
#include "raytrace/base/tile_tracer.h"

namespace ps {

/// Pixels one after the other by the clear path. `inputs` must stay.
template <class Real>
std::unique_ptr<TileTracer> clear_tiles(const TraceInputs<Real>& inputs, const SamplingPlan& plan);

}  // namespace ps
