#pragma once
#include <functional>

#include "frame/frame.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "hardware/driver.h"
#include "hardware/picture_plan.h"
#include "record/story.h"
#include "scene/scene.h"

namespace ps::hardware {

/// For the renderer's row (record/renderer_row.h). Both throw InputError with the reason where there is no driver, and
/// for what the driver has no room for.
Frame render_hardware(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                      Prepared& prepared, Progress& progress);
PixelStory inspect_hardware(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                            Prepared& prepared, Progress& progress);

/// The driver of this machine. Throws InputError with the reason where there is none, or for a picture that is larger
/// than it can draw.
const Driver& require_driver(const View& view);

/// Draws and makes what the picture's own passes look up: shadow maps, environment maps, shadow volumes. `done` hears
/// of each when it is there.
void draw_ahead(PicturePlan& plan, Prepared& prepared, WorkerPriority priority, Progress& progress,
                const std::function<void(const char* stage)>& done);

}  // namespace ps::hardware
