#include "render/render.h"

#include "base/check.h"
#include "image/image.h"

namespace ps {

Frame render(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
             Prepared& prepared, Progress& progress) {
  require_image_size(view.width, view.height, "picture");
  switch (settings.renderer) {
  case Renderer::ray_tracer:
    return render_traced(scene, view, settings, request, prepared, progress);
  case Renderer::rasterizer:
    return render_rasterized(scene, view, settings, request, prepared, progress);
  case Renderer::textbook:
    return render_textbook(scene, view, settings, request, prepared, progress);
  }
  return {};
}

Frame render(const Scene& scene, const View& view, const Settings& settings) {
  Prepared prepared;
  Progress progress;
  return render(scene, view, settings, {}, prepared, progress);
}

PixelStory inspect(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
                   Progress& progress) {
  require_image_size(view.width, view.height, "picture");
  PS_ASSERT(pixel.x >= 0 && pixel.y >= 0 && pixel.x < view.width && pixel.y < view.height, "pixel outside the view");
  switch (settings.renderer) {
  case Renderer::ray_tracer:
    return inspect_traced(scene, view, settings, pixel, prepared, progress);
  case Renderer::rasterizer:
    return inspect_rasterized(scene, view, settings, pixel, prepared, progress);
  case Renderer::textbook:
    return inspect_textbook(scene, view, settings, pixel, prepared, progress);
  }
  return {};
}

}  // namespace ps
