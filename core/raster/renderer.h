#pragma once
#include "record/renderer_row.h"

namespace ps {

/// The rasterizer (CGFS part II).
RendererRow rasterizer_row();

/// What the row holds, for those who want this renderer alone.
Frame render_rasterized(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                        Prepared& prepared, Progress& progress);
PixelStory inspect_rasterized(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                              Prepared& prepared, Progress& progress);
FastPath rasterized_fast_path(const Settings& settings, const SceneTraits& traits, Channel channels);

}  // namespace ps
