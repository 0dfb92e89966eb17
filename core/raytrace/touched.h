#pragma once
#include "frame/prepared.h"
#include "frame/view.h"
#include "options/settings.h"
#include "record/touched.h"
#include "scene/scene.h"

namespace ps {

/// Notes where the rays of the ray tracer end when it draws this picture: eye rays, shadow rays, reflected and
/// refracted ones, of every sample of every pixel. The clear path shades them, with the settings as they are; with
/// adaptive sampling, all samples of each pixel. What blocks a shadow ray is the nearest thing in its way. Throws
/// Cancelled.
Touched touched_by_rays(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                        Progress& progress, WorkerPriority priority);

}  // namespace ps
