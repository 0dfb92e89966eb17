#include "raster/base/fast_path.h"
#include "raster/renderer.h"
#include "raster/setup/left_out.h"
#include "raster/slow_motion.h"

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

std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings) {
  constexpr std::string_view subject = "The rasterizer";
  std::vector<LeftOut> all = left_out_by_fragments(traits, settings, subject);
  if (settings.precision == Precision::float32)
    if (auto rounded = rounded_by_fragments(traits, settings, subject, {"Double", "precision=double"}))
      all.push_back(std::move(*rounded));
  return all;
}

}  // namespace

RendererRow rasterizer_row() {
  return {.renderer = Renderer::rasterizer,
          .render = render_rasterized,
          .inspect = inspect_rasterized,
          .find_field = find_field_of_fragments,
          .counts = fragment_counts,
          .fast_path = rasterized_fast_path,
          .left_out = left_out,
          .shows_objects = fragments_show_objects,
          .subject = [](const SceneTraits&, const Settings&) { return std::string("the rasterizer"); },
          .slow_motion_lacks = rasterized_slow_motion_lacks,
          .slow_motion = rasterize_slowly};
}

}  // namespace ps
