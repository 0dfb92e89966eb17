#include "raytrace/renderer.h"

#include "base/timer.h"
#include "frame/display_frame.h"
#include "frame/region.h"
#include "raytrace/packet.h"
#include "raytrace/packet_shader.h"
#include "raytrace/sampling/packet_many.h"
#include "raytrace/sampling/subdivide.h"
#include "raytrace/sampling/tile_rays.h"
#include "raytrace/store_pixel.h"

namespace ps {
namespace {

/// Traces one picture, tile by tile.
template <class Real>
class PictureTracer {
 public:
  PictureTracer(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                Prepared& prepared, Progress& progress)
      : settings_(settings), request_(request), ids_asked_(has(request.channels, Channel::ids)),
        plan_(sampling_plan(settings)), parallel_{settings.threads, request.priority}, progress_(progress),
        inputs_(make_trace_inputs<Real>(scene, view, settings, prepared, request.channels)),
        tiles_(make_tiles(view.width, view.height, traced_tile_size)),
        region_(asked_region(request, view.width, view.height)) {
    if (plan_.mode == SamplingMode::adaptive) request_.channels = request_.channels | Channel::ids;
    if constexpr (std::is_same_v<Real, float>) {
      packets_ = packet_functions(settings.simd);
      scene_ = packet_scene(inputs_);
      hit_tables_ = hit_tables(inputs_);
    }
    frame_ = empty_frame<Real>(view, request_);
    frame_.path = used_path();
  }

  Frame trace() {
    const bool adaptive = plan_.mode == SamplingMode::adaptive;
    const TileRect all{0, 0, frame_.width(), frame_.height()};
    // Adaptive sampling compares with the pixels just outside, too.
    const TileRect wanted = adaptive ? common_part(grown(region_), all) : region_;
    for_each_tile([&](std::size_t index, Counters& counters) {
      const TileRect& tile = tiles_[index];
      const TileRect part = common_part(tile, wanted);
      if (is_empty(part)) return false;
      if (scene_ && plan_.mode == SamplingMode::many)
        trace_fast(pixels_of(part), counters);
      else if (scene_)
        packets_.tile(*scene_, tile, part, frame_, counters);
      else
        trace_part(tile, part, counters);
      store_sample_counts(part);
      return true;
    });
    if (adaptive) {
      subdivide();
      if (!ids_asked_) frame_.ids = {};
    }
    frame_.counters[Counter::triangles_degenerate] += inputs_.geometry->degenerate_triangles;
    if (inputs_.simple.octree) frame_.counters[Counter::octree_entries] += inputs_.simple.octree->entries.size();
    if (request_.region) clear_outside(region_, frame_);
    return std::move(frame_);
  }

 private:
  /// What draws the picture: what is allowed, unless there is nothing of the kind to draw.
  FastPath used_path() const {
    FastPath path = inputs_.path;
    if (path.machinery == Machinery::wide_triangles && !inputs_.wide && !inputs_.list)
      path = {Machinery::clear, SurfaceShading::single, "no triangle has an area"};
    if (path.machinery == Machinery::wide_triangles && path.shading != SurfaceShading::single && !hit_tables_)
      path = {Machinery::wide_triangles, SurfaceShading::single, "every surface is shaded one hit at a time"};
    return path;
  }

  /// Calls body(index, counters) for all tiles; those for which it returns true are shown.
  template <class Body>
  void for_each_tile(Body&& body) {
    std::vector<Counters> counters(tiles_.size());
    parallel_for(static_cast<int>(tiles_.size()), parallel_, progress_, [&](int index, int) {
      const auto i = static_cast<std::size_t>(index);
      if (body(i, counters[i])) finish_tile(request_, settings_, frame_, tiles_[i]);
    });
    for (const Counters& tile : counters) frame_.counters += tile;
  }

  /// The clear path for the pixels `part` of a tile.
  void trace_part(const TileRect& tile, const TileRect& part, Counters& counters) {
    CountingRecorder recorder;
    const bool one_ray = plan_.mode == SamplingMode::one || plan_.mode == SamplingMode::adaptive;
    if (one_ray && ((inputs_.wide && inputs_.packet_searches.nearest) || inputs_.list)) {
      const Tracer<Real, CountingRecorder> tracer(inputs_, recorder);
      if constexpr (std::is_same_v<Real, float>)
        if (hit_tables_) return trace_shaded(tracer, part, recorder, counters);
      for (int y = part.y0; y < part.y1; ++y)
        tracer.trace_pixels(part.x0, part.x1, y, [&](int x, const TracedPixel<Real>& pixel) {
          if (store_pixel(pixel, inputs_, x, y, frame_)) recorder.count(Counter::nan_pixels);
        });
    } else if (plan_.mode == SamplingMode::subsampling && frame_.tests.empty()) {
      const Tracer<Real, CountingRecorder> tracer(inputs_, recorder);
      const SubsampledTile<Real, CountingRecorder> between(tracer, inputs_, tile, plan_.step, recorder);
      for (int y = part.y0; y < part.y1; ++y)
        between.trace_pixels(part.x0, part.x1, y, [&](int x, const TracedPixel<Real>& pixel) {
          if (store_pixel(pixel, inputs_, x, y, frame_)) recorder.count(Counter::nan_pixels);
        });
    } else {
      const TileRays<Real, CountingRecorder> rays(inputs_, plan_, tile, recorder);
      for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x) {
          const std::uint64_t before = primitive_tests(recorder.counters);
          if (store_pixel(rays.pixel(x, y), inputs_, x, y, frame_)) recorder.count(Counter::nan_pixels);
          if (!frame_.tests.empty())
            frame_.tests.at(x, y) = static_cast<std::uint32_t>(primitive_tests(recorder.counters) - before);
        }
    }
    count_written(part, recorder);
    counters = recorder.counters;
  }

  /// One ray for each pixel, found and shaded by eight.
  void trace_shaded(const Tracer<float, CountingRecorder>& tracer, const TileRect& part, CountingRecorder& recorder,
                    Counters& counters) {
    PacketShader shader(inputs_, *hit_tables_, tracer, recorder);
    std::array<Vec3f, packet_width> colours;
    for (int y = part.y0; y < part.y1; ++y)
      tracer.find_pixels(part.x0, part.x1, y,
                         [&](int x, std::span<const Ray<float>> rays, std::span<const Hit<float>> hits) {
                           shader.shade(rays, hits, colours);
                           for (std::size_t i = 0; i < hits.size(); ++i)
                             if (store_hit(colours[i], hits[i], inputs_, x + static_cast<int>(i), y, frame_))
                               recorder.count(Counter::nan_pixels);
                         });
    count_written(part, recorder);
    counters = recorder.counters;
  }

  static void count_written(const TileRect& part, CountingRecorder& recorder) {
    recorder.count(Counter::pixels_written,
                   static_cast<std::uint64_t>(part.width()) * static_cast<std::uint64_t>(part.height()));
  }

  static std::vector<Vec2i> pixels_of(const TileRect& part) {
    std::vector<Vec2i> pixels;
    for (int y = part.y0; y < part.y1; ++y)
      for (int x = part.x0; x < part.x1; ++x) pixels.push_back({x, y});
    return pixels;
  }

  /// The fast path for several samples of each of these pixels.
  void trace_fast(const std::vector<Vec2i>& pixels, Counters& counters) {
    trace_many_packets(*scene_, packets_.samples, plan_, pixels, frame_, counters);
    counters[Counter::pixels_written] += pixels.size();
  }

  void store_sample_counts(const TileRect& part) {
    if (frame_.samples.empty()) return;
    const bool many = plan_.mode == SamplingMode::many;
    for (int y = part.y0; y < part.y1; ++y)
      for (int x = part.x0; x < part.x1; ++x)
        frame_.samples.at(x, y) = many ? static_cast<std::uint32_t>(plan_.samples) : 1u;
  }

  /// The second pass of adaptive sampling: pixels whose first ray differs from a neighbour's are traced as with a fixed
  /// number of samples.
  void subdivide() {
    const Image<std::uint8_t> chosen = pixels_to_subdivide(frame_, region_, plan_);
    SamplingPlan many = plan_;
    many.mode = SamplingMode::many;
    std::vector<std::uint64_t> nan_before(tiles_.size());
    for_each_tile([&](std::size_t index, Counters& counters) {
      std::vector<Vec2i> pixels;
      for (const Vec2i& pixel : pixels_of(common_part(tiles_[index], region_)))
        if (chosen.at(pixel.x, pixel.y) != 0) pixels.push_back(pixel);
      for (const Vec2i& pixel : pixels) {
        nan_before[index] += has_nan(frame_.colour.at(pixel.x, pixel.y)) ? 1 : 0;
        if (!frame_.samples.empty()) frame_.samples.at(pixel.x, pixel.y) = static_cast<std::uint32_t>(plan_.samples);
      }
      if (scene_)
        trace_many_packets(*scene_, packets_.samples, plan_, pixels, frame_, counters);
      else
        subdivide_tile(many, tiles_[index], pixels, counters);
      counters[Counter::pixels_subdivided] += pixels.size();
      return !pixels.empty();
    });
    for (const std::uint64_t nan : nan_before) frame_.counters[Counter::nan_pixels] -= nan;
  }

  void subdivide_tile(const SamplingPlan& many, const TileRect& tile, const std::vector<Vec2i>& pixels,
                      Counters& counters) {
    CountingRecorder recorder;
    const TileRays<Real, CountingRecorder> rays(inputs_, many, tile, recorder);
    for (const Vec2i& pixel : pixels) {
      const int x = pixel.x, y = pixel.y;
      const std::uint64_t before = primitive_tests(recorder.counters);
      if (store_pixel(rays.pixel(x, y), inputs_, x, y, frame_)) recorder.count(Counter::nan_pixels);
      if (!frame_.tests.empty())
        frame_.tests.at(x, y) += static_cast<std::uint32_t>(primitive_tests(recorder.counters) - before);
    }
    counters = recorder.counters;
  }

  static bool has_nan(const Vec3f& c) { return std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z); }

  const Settings& settings_;
  RenderRequest request_;
  bool ids_asked_;
  SamplingPlan plan_;
  ParallelOptions parallel_;
  Progress& progress_;
  TraceInputs<Real> inputs_;
  std::vector<TileRect> tiles_;
  TileRect region_;
  PacketFunctions packets_;
  std::optional<PacketScene> scene_;
  std::optional<HitTables> hit_tables_;
  Frame frame_;
};

template <class Real>
Frame render_in(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                Prepared& prepared, Progress& progress) {
  const Timer preparing;
  PictureTracer<Real> tracer(scene, view, settings, request, prepared, progress);
  const double prepared_ms = preparing.milliseconds();
  const Timer tracing;
  Frame frame = tracer.trace();
  frame.times.push_back({"prepare", prepared_ms});
  frame.times.push_back({"trace", tracing.milliseconds()});
  return frame;
}

}  // namespace

Frame render_traced(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                    Prepared& prepared, Progress& progress) {
  switch (settings.precision) {
  case Precision::float32:
    return render_in<float>(scene, view, settings, request, prepared, progress);
  case Precision::float64:
    return render_in<double>(scene, view, settings, request, prepared, progress);
  }
  return {};
}

}  // namespace ps
