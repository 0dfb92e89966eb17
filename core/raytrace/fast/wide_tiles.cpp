#include <algorithm>
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

  /// Calls use(pixels, rays, hits) for all pixels of a part, up to `shaded_together` at a time. Eye rays are made and
  /// searched for in blocks of 16 x 4 pixels, which are four of 4 x 4: what goes together should be near each other.
  template <class Use>
  void find_pixels(const Eye& eye, const TileRect& part, Use&& use) const {
    constexpr int group = 4, columns = 16, rows = 4;
    static_assert(columns * rows == rays_at_once && group * rows == most_in_packet);
    std::array<Ray<float>, rays_at_once> rays;
    std::array<Hit<float>, rays_at_once> hits;
    std::array<Vec2i, rays_at_once> pixels;
    rays.fill(eye_ray_to(inputs_, 0.0f, Vec3f(0)));
    std::array<float, columns> across;
    for (int top = part.y0; top < part.y1; top += rows)
      for (int left = part.x0; left < part.x1; left += columns) {
        const int right = std::min(left + columns, part.x1), bottom = std::min(top + rows, part.y1);
        for (int x = left; x < right; ++x) across[static_cast<std::size_t>(x - left)] = inputs_.viewport.at(x, top).x;
        std::size_t count = 0;
        for (int first = left; first < right; first += group)
          for (int y = top; y < bottom; ++y) {
            const Vec3f upwards = inputs_.up * inputs_.viewport.at(first, y).y;  // the same for the row
            for (int x = first; x < std::min(first + group, right); ++x, ++count) {
              aim(inputs_, rays[count], across[static_cast<std::size_t>(x - left)], upwards);
              pixels[count] = {x, y};
            }
          }
        eye.find(std::span<const Ray<float>>(rays).first(count), std::span(hits).first(count));
        for (std::size_t i = 0; i < count; i += shaded_together) {
          const std::size_t some = std::min(shaded_together, count - i);
          use(std::span<const Vec2i>(pixels).subspan(i, some), std::span<const Ray<float>>(rays).subspan(i, some),
              std::span<const Hit<float>>(hits).subspan(i, some));
        }
      }
  }

  /// One ray for each pixel, found together.
  void trace_found(const Eye& eye, const TileRect& part, Frame& frame) const {
    TracedPixel<float> pixel;
    find_pixels(eye, part, [&](auto pixels, auto rays, auto hits) {
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        eye.trace_known(rays[i], hits[i], pixel);
        store(pixel, pixels[i].x, pixels[i].y, frame, eye.recorder());
      }
    });
  }

  /// One ray for each pixel, found and shaded together.
  void trace_shaded(const Eye& eye, const TileRect& part, Frame& frame) const {
    PacketShader shader(inputs_, *hit_tables_, eye, eye.recorder());
    std::array<Vec3f, shaded_together> colours;
    find_pixels(eye, part, [&](auto pixels, auto rays, auto hits) {
      shader.shade(rays, hits, colours);
      for (std::size_t i = 0; i < pixels.size(); ++i)
        if (store_hit(colours[i], hits[i], inputs_, pixels[i].x, pixels[i].y, frame))
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
