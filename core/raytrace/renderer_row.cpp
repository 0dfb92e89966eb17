#include "raytrace/renderer.h"

namespace ps {
namespace {

bool rays_show_objects(const SceneTraits& traits, const Settings&) {
  return traits.spheres || traits.triangles || traits.solids || traits.csg;
}

std::vector<LeftOut> left_out_by_rays(const SceneTraits& traits, const Settings&) {
  if (!traits.canvas_items) return {};
  return {{LeftOutKind::objects, "leaves out what is drawn on the canvas",
           "The ray tracer leaves out lines and triangles on the canvas, which no ray hits. Set renderer = rasterizer "
           "to see them."}};
}

}  // namespace

RendererRow ray_tracer_row() {
  return {.renderer = Renderer::ray_tracer,
          .render = render_traced,
          .inspect = inspect_traced,
          .fast_path = traced_fast_path,
          .left_out = left_out_by_rays,
          .shows_objects = rays_show_objects,
          .subject = [](const SceneTraits&, const Settings&) { return std::string("the ray tracer"); }};
}

}  // namespace ps
