#include "raytrace/fast/packet_many.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "math/has_nan.h"
#include "raytrace/sampling/middle_sample.h"
#include "raytrace/sampling/pattern.h"

namespace ps {
namespace {

constexpr std::size_t samples_at_once = 256;

void store(const PacketScene& scene, const PacketResult& middle, const Vec3f& colour, Vec2i pixel, Frame& frame) {
  frame.colour.at(pixel.x, pixel.y) = colour;
  const bool hit = middle.sphere >= 0;
  if (!frame.ids.empty())
    frame.ids.at(pixel.x, pixel.y) = hit ? scene.spheres[static_cast<std::size_t>(middle.sphere)].id : PixelId{};
  if (!frame.depth.empty())
    frame.depth.at(pixel.x, pixel.y) =
        hit ? middle.t * scene.viewport.distance : std::numeric_limits<float>::infinity();
}

}  // namespace

void trace_many_packets(const PacketScene& scene, TraceSamples trace, const SamplingPlan& plan,
                        std::span<const Vec2i> pixels, Frame& frame, Counters& counters) {
  const auto count = static_cast<std::size_t>(plan.averaged());
  const std::size_t pixels_at_once = std::max<std::size_t>(1, samples_at_once / count);
  std::vector<PacketSample> samples(pixels_at_once * count);
  std::vector<PacketResult> results(samples.size());
  std::vector<std::size_t> middles(pixels_at_once);
  for (std::size_t first = 0; first < pixels.size(); first += pixels_at_once) {
    const auto some = pixels.subspan(first, std::min(pixels_at_once, pixels.size() - first));
    for (std::size_t p = 0; p < some.size(); ++p) {
      MiddleSample middle;
      for (std::size_t i = 0; i < count; ++i) {
        const Vec2d offset =
            sample_in_pixel(plan.pattern, static_cast<int>(i), plan.samples, some[p], scene.viewport.sample);
        samples[p * count + i] = {some[p].x, some[p].y, static_cast<float>(offset.x), static_cast<float>(offset.y)};
        if (middle.is_nearer(offset, scene.viewport.sample)) middles[p] = p * count + i;
      }
    }
    const std::size_t used = some.size() * count;
    trace(scene, std::span(samples).first(used), results, counters);
    for (std::size_t p = 0; p < some.size(); ++p) {
      Vec3f sum(0);
      for (std::size_t i = 0; i < count; ++i) sum += results[p * count + i].colour;
      const Vec3f colour = sum / static_cast<float>(plan.averaged());
      if (has_nan(colour)) ++counters[Counter::nan_pixels];
      store(scene, results[middles[p]], colour, some[p], frame);
    }
  }
}

}  // namespace ps
