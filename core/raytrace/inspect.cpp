#include <algorithm>

#include "frame/display_frame.h"
#include "image/display.h"
#include "raytrace/clear/tile_rays.h"
#include "raytrace/renderer.h"
#include "raytrace/sampling/compare.h"
#include "raytrace/shadow_maps.h"

namespace ps {
namespace {

/// Repeats what the renderer does for one pixel, from the start of its tile where that matters.
template <class Real>
class PixelInspection {
 public:
  PixelInspection(const TraceInputs<Real>& inputs, const View& view, Vec2i pixel, PixelRecorder& recorder)
      : inputs_(inputs), plan_(sampling_plan(inputs.settings)), size_{view.width, view.height}, pixel_(pixel),
        recorder_(recorder) {
    for (const TileRect& tile : make_tiles(view.width, view.height, traced_tile_size))
      if (tile.contains(pixel.x, pixel.y)) tile_ = tile;
  }

  Vec3<Real> trace() {
    const Vec3<Real> colour = trace_with(plan_);
    if (plan_.mode != SamplingMode::adaptive || !differs(colour)) return colour;
    SamplingPlan many = plan_;
    many.mode = SamplingMode::many;
    return trace_with(many);
  }

 private:
  Vec3<Real> trace_with(const SamplingPlan& plan) {
    const Counters counters = recorder_.counters;
    recorder_.mute(true);
    const Tracer<Real, PixelRecorder> tracer(inputs_, recorder_);
    const TileRays<Real, PixelRecorder> rays(tracer, plan, tile_);
    if (inputs_.settings.shadow_cache) trace_pixels_before(rays, plan);
    recorder_.mute(false);
    recorder_.counters = counters;
    const TracedPixel<Real> traced = rays.pixel(pixel_.x, pixel_.y);
    id_ = traced.hit.found() ? id_of(*inputs_.geometry, traced.hit) : PixelId{};
    return traced.colour;
  }

  /// What they leave in the shadow cache decides which blocker is tested first. Of an adaptive picture's second pass
  /// only those that it chose.
  void trace_pixels_before(const TileRays<Real, PixelRecorder>& rays, const SamplingPlan& plan) const {
    const bool chosen_only = plan_.mode == SamplingMode::adaptive && plan.mode == SamplingMode::many;
    const Image<FirstRay> first = chosen_only ? first_rays_of_tile() : Image<FirstRay>();
    for (int y = tile_.y0; y <= pixel_.y; ++y)
      for (int x = tile_.x0; x < (y == pixel_.y ? pixel_.x : tile_.x1); ++x)
        if (!chosen_only || is_chosen(first, {x, y})) rays.pixel(x, y);
  }

  /// The first rays of the tile and one pixel around it, as far as the picture goes: pixel (x, y) is at
  /// (x - tile_.x0 + 1, y - tile_.y0 + 1).
  Image<FirstRay> first_rays_of_tile() const {
    Image<FirstRay> first(tile_.width() + 2, tile_.height() + 2);
    Silent silent;
    const Tracer<Real, Silent> tracer(inputs_, silent);
    for (int y = std::max(tile_.y0 - 1, 0); y < std::min(tile_.y1 + 1, size_.y); ++y)
      for (int x = std::max(tile_.x0 - 1, 0); x < std::min(tile_.x1 + 1, size_.x); ++x) {
        const TracedPixel<Real> traced = tracer.trace_pixel(x, y);
        const PixelId id = traced.hit.found() ? id_of(*inputs_.geometry, traced.hit) : PixelId{};
        first.at(x - tile_.x0 + 1, y - tile_.y0 + 1) = {id, Vec3d(Vec3f(traced.colour))};
      }
    return first;
  }

  bool is_chosen(const Image<FirstRay>& first, Vec2i pixel) const {
    const auto at = [&](Vec2i p) { return first.at(p.x - tile_.x0 + 1, p.y - tile_.y0 + 1); };
    return std::any_of(neighbour_steps.begin(), neighbour_steps.end(), [&](const Vec2i& step) {
      const Vec2i place = pixel + step;
      if (place.x < 0 || place.y < 0 || place.x >= size_.x || place.y >= size_.y) return false;
      return compare_rays(at(pixel), at(place), place, plan_.threshold).subdivides;
    });
  }

  /// Does the first ray differ from a neighbour's?
  bool differs(const Vec3<Real>& colour) {
    const FirstRay own{id_, Vec3d(colour)};
    const Counters counters = recorder_.counters;
    bool subdivides = false;
    for (const Vec2i& step : neighbour_steps) {
      const Vec2i place = pixel_ + step;
      if (place.x < 0 || place.y < 0 || place.x >= size_.x || place.y >= size_.y) continue;
      recorder_.mute(true);
      const TracedPixel<Real> traced = Tracer<Real, PixelRecorder>(inputs_, recorder_).trace_pixel(place.x, place.y);
      recorder_.mute(false);
      const PixelId id = traced.hit.found() ? id_of(*inputs_.geometry, traced.hit) : PixelId{};
      const CompareEvent event = compare_rays(own, {id, Vec3d(traced.colour)}, place, plan_.threshold);
      recorder_.event([&] { return event; });
      subdivides = subdivides || event.subdivides;
    }
    recorder_.counters = counters;
    return subdivides;
  }

  const TraceInputs<Real>& inputs_;
  SamplingPlan plan_;
  Vec2i size_, pixel_;
  PixelRecorder& recorder_;
  TileRect tile_;
  PixelId id_;
};

template <class Real>
PixelStory inspect_in(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
                      Progress& progress) {
  TraceInputs<Real> inputs = make_trace_inputs<Real>(scene, view, settings, prepared);
  add_shadow_maps(inputs, scene, prepared, WorkerPriority::normal, progress);
  PixelRecorder recorder(pixel);
  PixelStory story;
  story.pixel = pixel;
  story.renderer = Renderer::ray_tracer;
  story.linear = Vec3d(PixelInspection<Real>(inputs, view, pixel, recorder).trace());
  const Rgb8 display = display_pixel(story.linear, display_transform(settings));
  story.display = {display.r, display.g, display.b};
  recorder.event([&] { return PixelEvent{story.linear, story.display}; });
  story.events = recorder.take();
  story.counters = recorder.counters;
  return story;
}

}  // namespace

PixelStory inspect_traced(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                          Prepared& prepared, Progress& progress) {
  progress.check();
  switch (settings.precision) {
  case Precision::float32:
    return inspect_in<float>(scene, view, settings, pixel, prepared, progress);
  case Precision::float64:
    return inspect_in<double>(scene, view, settings, pixel, prepared, progress);
  }
  return {};
}

}  // namespace ps
