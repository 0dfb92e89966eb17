#pragma once
#include "frame/frame.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "record/story.h"
#include "scene/scene.h"

namespace ps::hardware {

/// For the renderer's row (record/renderer_row.h). Both throw InputError with the reason where there is no driver, and
/// for what the driver has no room for.
Frame render_hardware(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                      Prepared& prepared, Progress& progress);
PixelStory inspect_hardware(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                            Prepared& prepared, Progress& progress);

}  // namespace ps::hardware
