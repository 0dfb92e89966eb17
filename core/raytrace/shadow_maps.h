#pragma once
#include "base/progress.h"
#include "frame/prepared.h"
#include "raytrace/base/trace_inputs.h"

namespace ps {

/// With shadows = map the light at each point that a ray meets is looked up in shadow maps (CGPP 15.6.5). They are
/// those of the rasterizer, which draws them and keeps them in `prepared`. Throws InputError where they need more
/// memory than there is.
template <class Real>
void add_shadow_maps(TraceInputs<Real>& inputs, const Scene& scene, Prepared& prepared, WorkerPriority priority,
                     Progress& progress);

}  // namespace ps
