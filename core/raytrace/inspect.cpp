#include "image/display.h"
#include "inspect/finish_story.h"
#include "raytrace/tracer.h"
#include "render/render.h"

namespace ps {
namespace {

template <class Real>
PixelStory inspect_in(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared) {
  const TraceInputs<Real> inputs = make_trace_inputs<Real>(scene, view, settings, prepared);
  PixelRecorder recorder(pixel);
  const TracedPixel<Real> traced = Tracer<Real, PixelRecorder>(inputs, recorder).trace_pixel(pixel.x, pixel.y);
  PixelStory story;
  story.pixel = pixel;
  story.renderer = Renderer::ray_tracer;
  story.linear = Vec3d(traced.colour);
  const Rgb8 display = display_pixel(story.linear, display_transform(settings));
  story.display = {display.r, display.g, display.b};
  recorder.event([&] { return PixelEvent{story.linear, story.display}; });
  story.events = recorder.take();
  story.counters = recorder.counters;
  finish_story(story, scene, settings);
  return story;
}

}  // namespace

PixelStory inspect_traced(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                          Prepared& prepared, Progress& progress) {
  progress.check();
  switch (settings.precision) {
  case Precision::float32:
    return inspect_in<float>(scene, view, settings, pixel, prepared);
  case Precision::float64:
    return inspect_in<double>(scene, view, settings, pixel, prepared);
  }
  return {};
}

}  // namespace ps
