#pragma once
#include <memory>

#include "frame/prepared.h"
#include "frame/view.h"
#include "raster/stage_values.h"

namespace ps::hardware {

/// What the driver has after each stage: the scene drawn again by the same shaders, as for deferred shading, into
/// buffers of floats that are read back.
std::shared_ptr<const StageValues> stage_values(const Scene& scene, const View& view, const Settings& settings,
                                                Prepared& prepared, Progress& progress);

}  // namespace ps::hardware
