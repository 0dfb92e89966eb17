#include "raster/renderer.h"

namespace ps {
namespace {

constexpr CounterSet fragment_counts{Counter::shading_calls,
                                     Counter::light_samples,
                                     Counter::texel_reads,
                                     Counter::triangles_in,
                                     Counter::objects_culled,
                                     Counter::triangles_backfacing,
                                     Counter::triangles_clipped_away,
                                     Counter::triangles_split,
                                     Counter::triangles_degenerate,
                                     Counter::triangles_drawn,
                                     Counter::coverage_tests,
                                     Counter::coverage_regions,
                                     Counter::fragments,
                                     Counter::subsamples,
                                     Counter::depth_tests,
                                     Counter::depth_failures,
                                     Counter::attributes_interpolated,
                                     Counter::pixels_written,
                                     Counter::lines_drawn,
                                     Counter::nan_pixels,
                                     Counter::shadow_map_taps,
                                     Counter::silhouette_edges,
                                     Counter::stencil_tests,
                                     Counter::stencil_updates,
                                     Counter::environment_reads};

bool fragments_show_objects(const SceneTraits& traits, const Settings&) {
  return traits.spheres || traits.triangles || traits.solids || traits.canvas_items;
}

std::vector<LeftOut> left_out_by_fragments(const SceneTraits& traits, const Settings& settings) {
  const Remedy rays{"Ray tracer", "renderer=ray-tracer"};
  std::vector<LeftOut> all;
  if (traits.csg)
    all.push_back({LeftOutKind::objects,
                   "leaves out CSG",
                   "The rasterizer leaves out CSG objects, whose surfaces are computed per ray and not as triangles. "
                   "Set renderer = ray-tracer to see them.",
                   "No CSG: its surfaces need rays.",
                   {rays}});
  if (traits.transparent)
    all.push_back({LeftOutKind::effect,
                   "shows transparent surfaces as opaque",
                   "The rasterizer shows transparent surfaces as opaque, or cuts them out where an opacity map is "
                   "below 1/2. Set renderer = ray-tracer to see through them.",
                   "No transparency: light through a surface needs rays.",
                   {rays}});
  if (traits.light_maps && settings.textures && settings.lighting && settings.shading != Shading::phong)
    all.push_back({LeftOutKind::effect,
                   "leaves out specular maps",
                   "With flat or Gouraud shading the rasterizer leaves out maps of highlights and ambient light. Set "
                   "shading = phong to see them.",
                   "No specular maps: they need the light at each pixel.",
                   {{"Phong shading", "shading=phong"}}});
  if (asks_for_shadows(traits, settings) && settings.shadows == Shadows::traced)
    all.push_back({LeftOutKind::effect,
                   "leaves out shadows",
                   "The rasterizer has no shadow rays, so shadows = traced leaves out the shadows. Set shadows = map "
                   "or stencil-depth-fail to see them.",
                   "No shadows: traced shadows need rays.",
                   {{"Shadow map", "shadows=map"}, {"Stencil", "shadows=stencil-depth-fail"}}});
  if (asks_for_reflections(traits, settings) && settings.environment == Environment::none)
    all.push_back({LeftOutKind::effect,
                   "leaves out reflections",
                   "The rasterizer traces no reflected rays, so it leaves out reflections. Set environment = cube-map "
                   "to see them.",
                   "No reflections: reflected rays need a ray tracer.",
                   {{"Cube map", "environment=cube-map"}, rays}});
  if (asks_for_reflections(traits, settings) && traits.dynamic && settings.environment != Environment::none &&
      settings.environment_objects == EnvironmentObjects::fixed)
    all.push_back({LeftOutKind::effect,
                   "leaves dynamic objects out of mirrors",
                   "The rasterizer leaves dynamic objects out of the environment maps, so no mirror shows them. Set "
                   "environment-objects = all to see them there.",
                   "No dynamic objects in mirrors.",
                   {{"All objects", "environment-objects=all"}}});
  return all;
}

}  // namespace

RendererRow rasterizer_row() {
  return {.renderer = Renderer::rasterizer,
          .render = render_rasterized,
          .inspect = inspect_rasterized,
          .counts = fragment_counts,
          .fast_path = rasterized_fast_path,
          .left_out = left_out_by_fragments,
          .shows_objects = fragments_show_objects,
          .subject = [](const SceneTraits&, const Settings&) { return std::string("the rasterizer"); }};
}

}  // namespace ps
