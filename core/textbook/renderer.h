#pragma once
#include "record/renderer_row.h"

namespace ps {

/// The renderer that runs the listings of the lessons, line by line.
RendererRow textbook_row();

/// The functions of the row, for callers of this renderer alone.
Frame render_textbook(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                      Prepared& prepared, Progress& progress);
PixelStory inspect_textbook(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                            Prepared& prepared, Progress& progress);

}  // namespace ps
