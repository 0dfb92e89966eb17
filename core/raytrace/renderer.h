#pragma once
#include "raytrace/sampling/plan.h"
#include "record/renderer_row.h"

namespace ps {

/// The ray tracer (CGFS part I).
RendererRow ray_tracer_row();

/// What the row holds, for those who want this renderer alone.
Frame render_traced(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                    Prepared& prepared, Progress& progress);
PixelStory inspect_traced(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                          Prepared& prepared, Progress& progress);
/// One number of every pixel's story into `values`.
void find_field_of_rays(const FieldInputs& asked, Image<float>& values, Prepared& prepared, Progress& progress);
/// render_traced() with the samples of `plan` in place of those that the settings ask for.
Frame render_planned(const Scene& scene, const View& view, const Settings& settings, const SamplingPlan& plan,
                     const RenderRequest& request, Prepared& prepared, Progress& progress);

}  // namespace ps
