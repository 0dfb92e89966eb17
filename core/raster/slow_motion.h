#pragma once
#include "record/renderer_row.h"

namespace ps {

/// Slow motion of the rasterizer (record/renderer_row.h): after n triangles, fragments or tiles. Where the
/// settings ask for several walks over the triangles (raster/setup/draw_stage.h), each walk counts them anew.
std::optional<std::string_view> rasterized_slow_motion_lacks(SlowUnit unit, const Settings& settings,
                                                             const SceneTraits& traits);
SlowFrame rasterize_slowly(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
                           const RenderRequest& request, Prepared& prepared, Progress& progress);

}  // namespace ps
