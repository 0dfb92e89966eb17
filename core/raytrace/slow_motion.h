#pragma once
#include "record/renderer_row.h"

namespace ps {

/// Slow motion of the ray tracer (record/renderer_row.h): pixels, rows and tiles of the finished picture, or the mean
/// of the first samples.
std::optional<std::string_view> traced_slow_motion_lacks(SlowUnit unit, const Settings& settings,
                                                         const SceneTraits& traits);
SlowFrame trace_slowly(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
                       const RenderRequest& request, Prepared& prepared, Progress& progress);

}  // namespace ps
