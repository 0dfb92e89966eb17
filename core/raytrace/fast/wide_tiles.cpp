#include <array>

#include "raytrace/clear/store_pixel.h"
#include "raytrace/clear/tile_rays.h"
#include "raytrace/fast/fast_intersector.h"
#include "raytrace/fast/fast_tiles.h"
#include "raytrace/fast/packet_shader.h"

namespace ps {
namespace {

/// The clear path's tracer with the SIMD search. Eye rays of neighbouring pixels go together, and where the surfaces
/// allow it their hits are shaded together, too.
class WideTiles final : public TileTracer {
 public:
  WideTiles(const TraceInputs<float>& inputs, WideInputs wide, const SamplingPlan& plan)
      : inputs_(inputs), wide_(std::move(wide)), plan_(plan), hit_tables_(hit_tables(inputs)) {}

  FastPath path() const override {
    if (inputs_.path.shading == SurfaceShading::single || hit_tables_) return inputs_.path;
    return {Machinery::wide_triangles, SurfaceShading::single, "every surface is shaded one hit at a time"};
  }

  void trace(const TileRect& tile, const TileRect& part, Frame& frame, Counters& counters) const override {
    CountingRecorder recorder;
    const FastIntersector search(inputs_, wide_, recorder);
    const Eye eye(inputs_, recorder, search);
    switch (plan_.mode) {
    case SamplingMode::one:
    case SamplingMode::adaptive:
      if (hit_tables_)
        trace_shaded(eye, part, frame);
      else
        trace_found(eye, part, frame);
      break;
    case SamplingMode::subsampling:
      trace_between(eye, tile, part, frame);
      break;
    case SamplingMode::many:
      for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x) store(trace_many(eye, plan_, {x, y}), x, y, frame, recorder);
      break;
    }
    recorder.count(Counter::pixels_written, pixel_count(part));
    counters = recorder.counters;
  }

  void subdivide(const TileRect&, std::span<const Vec2i> pixels, Frame& frame, Counters& counters) const override {
    CountingRecorder recorder;
    const FastIntersector search(inputs_, wide_, recorder);
    const Eye eye(inputs_, recorder, search);
    const SamplingPlan many = with_all_samples(plan_);
    for (const Vec2i& pixel : pixels) store(trace_many(eye, many, pixel), pixel.x, pixel.y, frame, recorder);
    counters = recorder.counters;
  }

 private:
  using Eye = Tracer<float, CountingRecorder>;

  void store(const TracedPixel<float>& pixel, int x, int y, Frame& frame, CountingRecorder& recorder) const {
    if (store_pixel(pixel, inputs_, x, y, frame)) recorder.count(Counter::nan_pixels);
  }

  /// Calls use(column, rays, hits) for up to packet_width pixels of a part of a row at a time, whose eye rays are
  /// searched for together.
  template <class Use>
  void find_pixels(const Eye& eye, int first_column, int end_column, int row, Use&& use) const {
    std::array<Ray<float>, packet_width> rays;
    std::array<Hit<float>, packet_width> hits;
    const Viewport<float>& viewport = inputs_.viewport;
    const Vec3f upwards = inputs_.up * viewport.at(first_column, row).y;  // the same for the row
    rays.fill(eye_ray_to(inputs_, 0.0f, upwards));
    for (int column = first_column; column < end_column;) {
      std::size_t count = 0;
      for (; count < packet_width && column + static_cast<int>(count) < end_column; ++count)
        aim(inputs_, rays[count], viewport.at(column + static_cast<int>(count), row).x, upwards);
      const auto some = std::span<const Ray<float>>(rays).first(count);
      eye.find(some, std::span(hits).first(count));
      use(column, some, std::span<const Hit<float>>(hits).first(count));
      column += static_cast<int>(count);
    }
  }

  /// One ray for each pixel, found by eight.
  void trace_found(const Eye& eye, const TileRect& part, Frame& frame) const {
    TracedPixel<float> pixel;
    for (int y = part.y0; y < part.y1; ++y)
      find_pixels(eye, part.x0, part.x1, y,
                  [&](int x, std::span<const Ray<float>> rays, std::span<const Hit<float>> hits) {
                    for (std::size_t i = 0; i < rays.size(); ++i) {
                      eye.trace_known(rays[i], hits[i], pixel);
                      store(pixel, x + static_cast<int>(i), y, frame, eye.recorder());
                    }
                  });
  }

  /// One ray for each pixel, found and shaded by eight.
  void trace_shaded(const Eye& eye, const TileRect& part, Frame& frame) const {
    PacketShader shader(inputs_, *hit_tables_, eye, eye.recorder());
    std::array<Vec3f, packet_width> colours;
    for (int y = part.y0; y < part.y1; ++y)
      find_pixels(eye, part.x0, part.x1, y,
                  [&](int x, std::span<const Ray<float>> rays, std::span<const Hit<float>> hits) {
                    shader.shade(rays, hits, colours);
                    for (std::size_t i = 0; i < hits.size(); ++i)
                      if (store_hit(colours[i], hits[i], inputs_, x + static_cast<int>(i), y, frame))
                        eye.recorder().count(Counter::nan_pixels);
                  });
  }

  void trace_between(const Eye& eye, const TileRect& tile, const TileRect& part, Frame& frame) const {
    const SubsampledTile<float, CountingRecorder> between(eye, tile, plan_.step);
    for (int y = part.y0; y < part.y1; ++y)
      between.trace_pixels(part.x0, part.x1, y,
                           [&](int x, const TracedPixel<float>& pixel) { store(pixel, x, y, frame, eye.recorder()); });
  }

  const TraceInputs<float>& inputs_;
  WideInputs wide_;
  SamplingPlan plan_;
  std::optional<HitTables> hit_tables_;
};

}  // namespace

std::unique_ptr<TileTracer> wide_tiles(const Scene& scene, const TraceInputs<float>& inputs, const SamplingPlan& plan,
                                       Prepared& prepared) {
  std::optional<WideInputs> wide = wide_inputs(scene, inputs, prepared);
  if (!wide) return nullptr;
  return std::make_unique<WideTiles>(inputs, std::move(*wide), plan);
}

}  // namespace ps
