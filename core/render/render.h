#pragma once
#include "base/progress.h"
#include "frame/frame.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "options/settings.h"
#include "record/field_query.h"
#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// Renders the scene as `settings` ask, with the renderer that they name. The result does not depend on the number of
/// threads, on the SIMD target, or on what `prepared` already holds. Throws InputError for a size outside
/// 1..max_image_pixels and Cancelled when `progress` is asked to stop.
Frame render(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
             Prepared& prepared, Progress& progress);

/// The same, for callers who want only a picture.
Frame render(const Scene& scene, const View& view, const Settings& settings);

/// Why the renderer cannot show that number for every pixel, as a sentence; empty where it can.
std::string_view no_field_reason(Renderer renderer, const FieldQuery& query);

/// Repeats the work of the renderer for one pixel (array position) and reports it. The pixel must lie in the view.
PixelStory inspect(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
                   Progress& progress);

}  // namespace ps
