#include "raytrace/base/fast_path.h"
#include "raytrace/renderer.h"
#include "raytrace/slow_motion.h"

namespace ps {
namespace {

constexpr CounterSet ray_counts{
    Counter::eye_rays,        Counter::shadow_rays,    Counter::reflection_rays,     Counter::refraction_rays,
    Counter::sphere_tests,    Counter::triangle_tests, Counter::solid_tests,         Counter::node_visits,
    Counter::edge_rays,       Counter::shading_calls,  Counter::light_samples,       Counter::texel_reads,
    Counter::shadow_map_taps, Counter::pixels_written, Counter::pixels_subdivided,   Counter::searches_saved,
    Counter::nan_pixels,      Counter::octree_entries, Counter::triangles_degenerate};

bool rays_show_objects(const SceneTraits& traits, const Settings&) {
  return traits.spheres || traits.triangles || traits.solids || traits.csg;
}

std::vector<LeftOut> left_out_by_rays(const SceneTraits& traits, const Settings& settings) {
  std::vector<LeftOut> all;
  if (traits.canvas_items)
    all.push_back({LeftOutKind::objects,
                   {BriefVerb::leaves_out, "what is drawn on the canvas"},
                   "The ray tracer leaves out lines and shapes on the canvas, which no ray hits. Set renderer = "
                   "rasterizer to see them.",
                   "Nothing of the canvas: no ray hits it.",
                   {{"Rasterizer", "renderer=rasterizer"}}});
  if (traits.outgrows_float && settings.precision == Precision::float32 && settings.camera_relative)
    all.push_back({LeftOutKind::effect,
                   {BriefVerb::own, "rounds away detail in float"},
                   "The ray tracer rounds away detail: it is too small for its distance from the scene's middle. The "
                   "scene needs precision = double.",
                   "Detail is rounded away: needs precision = double.",
                   {{"Double", "precision=double"}}});
  const bool casts = settings.lighting && traits.casting_lights;
  if (casts && (settings.shadows == Shadows::stencil_depth_fail || settings.shadows == Shadows::stencil_depth_pass))
    all.push_back({LeftOutKind::effect,
                   {BriefVerb::own, "traces its shadows"},
                   "The ray tracer casts a shadow ray to each light: it has no stencil buffer to count shadow volumes "
                   "in. Set renderer = rasterizer to see them.",
                   "Shadows are traced: shadow volumes need a stencil buffer.",
                   {{"Rasterizer", "renderer=rasterizer"}, {"Traced", "shadows=traced"}}});
  if (casts && settings.shadows == Shadows::map && traits.csg)
    all.push_back({LeftOutKind::effect,
                   {BriefVerb::leaves_out, "the shadows of CSG"},
                   "The ray tracer leaves out the shadows of CSG objects: shadow maps are drawn with triangles, and "
                   "these objects have none. Set shadows = traced to see them.",
                   "No shadows of CSG: shadow maps need triangles.",
                   {{"Traced", "shadows=traced"}}});
  if (auto dark = missing_light(traits, settings, "The ray tracer")) all.push_back(std::move(*dark));
  return all;
}

}  // namespace

RendererRow ray_tracer_row() {
  return {.renderer = Renderer::ray_tracer,
          .render = render_traced,
          .inspect = inspect_traced,
          .find_field = find_field_of_rays,
          .counts = ray_counts,
          .fast_path = traced_fast_path,
          .left_out = left_out_by_rays,
          .shows_objects = rays_show_objects,
          .subject = [](const SceneTraits&, const Settings&) { return std::string("the ray tracer"); },
          .slow_motion_lacks = traced_slow_motion_lacks,
          .slow_motion = trace_slowly};
}

}  // namespace ps
