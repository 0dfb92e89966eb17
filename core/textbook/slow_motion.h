#pragma once
#include "record/renderer_row.h"

namespace ps {

/// Slow motion of a listing (record/renderer_row.h): the pixels that it puts on the canvas, in the order of its loops.
/// It runs once on a canvas that holds the whole region, and its writes are kept.
std::optional<std::string_view> listing_slow_motion_lacks(SlowUnit unit, const Settings& settings,
                                                          const SceneTraits& traits);
SlowFrame run_listing_slowly(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
                             const RenderRequest& request, Prepared& prepared, Progress& progress);

}  // namespace ps
