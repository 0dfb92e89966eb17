#pragma once
#include "raytrace/clear/tracer.h"
#include "raytrace/sampling/middle_sample.h"
#include "raytrace/sampling/pattern.h"
#include "raytrace/sampling/plan.h"

namespace ps {

/// How many samples of an inspected pixel record their whole story; of the others only position, weight and colour are
/// kept.
inline constexpr int most_sample_stories = 16;

/// Supersampling (CGFS ch. 5): the mean of several rays, added up in their order.
template <class Real, class Recorder>
TracedPixel<Real> trace_many(const Tracer<Real, Recorder>& tracer, const SamplingPlan& plan, Vec2i place) {
  const Viewport<Real>& viewport = tracer.inputs().viewport;
  Recorder& recorder = tracer.recorder();
  TracedPixel<Real> pixel;
  Vec3<Real> sum(0);
  MiddleSample middle;
  [[maybe_unused]] const bool silent = !recorder.collects();  // a replay of what came before
  for (int i = 0; i < plan.averaged(); ++i) {
    const Vec2d offset = sample_in_pixel(plan.pattern, i, plan.samples, place, viewport.sample);
    SampleEvent event{i, plan.samples, offset, 1.0 / plan.averaged(), {}};
    recorder.begin([&] { return event; });
    if constexpr (Recorder::records) recorder.mute(silent || i >= most_sample_stories);
    const TracedPixel<Real> sample = tracer.trace_eye_ray(eye_ray(tracer.inputs(), place.x, place.y, offset));
    if constexpr (Recorder::records) recorder.mute(silent);
    event.colour = Vec3d(sample.colour);
    recorder.end([&] { return event; });
    sum += sample.colour;
    if (middle.is_nearer(offset, viewport.sample)) pixel = sample;
  }
  pixel.colour = sum / static_cast<Real>(plan.averaged());
  return pixel;
}

}  // namespace ps
