#include "render/render.h"

#include "base/check.h"
#include "base/stop.h"
#include "image/image.h"
#include "render/precision_channels.h"

namespace ps {
namespace {

Frame render_as_set(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                    Prepared& prepared, Progress& progress) {
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

}  // namespace

Frame render(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
             Prepared& prepared, Progress& progress) {
  require_image_size(view.width, view.height, "picture");
  const StopScope stop(&progress);
  RenderRequest plain = request;
  plain.channels = without(without(request.channels, Channel::precision), Channel::depth_gap);
  Frame frame = render_as_set(scene, view, settings, plain, prepared, progress);
  if (has(request.channels, Channel::precision))
    compare_with_double(frame, scene, view, settings, request, prepared, progress);
  if (has(request.channels, Channel::depth_gap))
    find_depth_gaps(frame, scene, view, settings, request, prepared, progress);
  return frame;
}

Frame render(const Scene& scene, const View& view, const Settings& settings) {
  Prepared prepared;
  Progress progress;
  return render(scene, view, settings, {}, prepared, progress);
}

PixelStory inspect(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
                   Progress& progress) {
  require_image_size(view.width, view.height, "picture");
  const StopScope stop(&progress);
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
