#include "raytrace/clear/clear_tiles.h"

#include "raytrace/clear/store_pixel.h"
#include "raytrace/clear/tile_rays.h"

namespace ps {
namespace {

template <class Real>
class ClearTiles final : public TileTracer {
 public:
  ClearTiles(const TraceInputs<Real>& inputs, const SamplingPlan& plan) : inputs_(inputs), plan_(plan) {}

  FastPath path() const override {
    if (inputs_.path.machinery == Machinery::clear) return inputs_.path;
    const bool spheres = inputs_.path.machinery == Machinery::sphere_packets;
    return {Machinery::clear, SurfaceShading::single,
            spheres ? "float cannot square a radius or the camera's axes" : "no triangle has an area"};
  }

  void trace(const TileRect& tile, const TileRect& part, Frame& frame, Counters& counters) const override {
    CountingRecorder recorder;
    const Tracer<Real, CountingRecorder> tracer(inputs_, recorder);
    const TileRays<Real, CountingRecorder> rays(tracer, plan_, tile);
    for (int y = part.y0; y < part.y1; ++y)
      for (int x = part.x0; x < part.x1; ++x) {
        const std::uint64_t before = primitive_tests(recorder.counters);
        if (store_pixel(rays.pixel(x, y), inputs_, x, y, frame)) recorder.count(Counter::nan_pixels);
        if (!frame.tests.empty())
          frame.tests.at(x, y) = static_cast<std::uint32_t>(primitive_tests(recorder.counters) - before);
      }
    recorder.count(Counter::pixels_written, pixel_count(part));
    counters = recorder.counters;
  }

  void subdivide(const TileRect& tile, std::span<const Vec2i> pixels, Frame& frame, Counters& counters) const override {
    CountingRecorder recorder;
    const Tracer<Real, CountingRecorder> tracer(inputs_, recorder);
    const SamplingPlan many = with_all_samples(plan_);
    const TileRays<Real, CountingRecorder> rays(tracer, many, tile);
    for (const Vec2i& pixel : pixels) {
      const std::uint64_t before = primitive_tests(recorder.counters);
      if (store_pixel(rays.pixel(pixel.x, pixel.y), inputs_, pixel.x, pixel.y, frame))
        recorder.count(Counter::nan_pixels);
      if (!frame.tests.empty())
        frame.tests.at(pixel.x, pixel.y) += static_cast<std::uint32_t>(primitive_tests(recorder.counters) - before);
    }
    counters = recorder.counters;
  }

 private:
  const TraceInputs<Real>& inputs_;
  SamplingPlan plan_;
};

}  // namespace

template <class Real>
std::unique_ptr<TileTracer> clear_tiles(const TraceInputs<Real>& inputs, const SamplingPlan& plan) {
  return std::make_unique<ClearTiles<Real>>(inputs, plan);
}

template std::unique_ptr<TileTracer> clear_tiles(const TraceInputs<float>&, const SamplingPlan&);
template std::unique_ptr<TileTracer> clear_tiles(const TraceInputs<double>&, const SamplingPlan&);

}  // namespace ps
