#include "raytrace/renderer.h"

#include "base/timer.h"
#include "frame/display_frame.h"
#include "frame/empty_frame.h"
#include "frame/region.h"
#include "math/has_nan.h"
#include "raster/shadow/map_picture.h"
#include "raytrace/clear/clear_tiles.h"
#include "raytrace/fast/fast_tiles.h"
#include "raytrace/sampling/subdivide.h"
#include "raytrace/shadow_maps.h"

namespace ps {
namespace {

// What draws the picture is chosen here, once.
std::unique_ptr<TileTracer> tile_tracer(const Scene& scene, const TraceInputs<float>& inputs, const SamplingPlan& plan,
                                        Prepared& prepared) {
  std::unique_ptr<TileTracer> fast = fast_tiles(scene, inputs, plan, prepared);
  return fast ? std::move(fast) : clear_tiles(inputs, plan);
}
std::unique_ptr<TileTracer> tile_tracer(const Scene&, const TraceInputs<double>& inputs, const SamplingPlan& plan,
                                        Prepared&) {
  return clear_tiles(inputs, plan);
}

/// Traces one picture, tile by tile.
template <class Real>
class PictureTracer {
 public:
  PictureTracer(const Scene& scene, const View& view, const Settings& settings, const SamplingPlan& plan,
                const RenderRequest& request, Prepared& prepared, Progress& progress)
      : settings_(settings), request_(request), ids_asked_(has(request.channels, Channel::ids)),
        plan_(plan), parallel_{settings.threads, request.priority}, progress_(progress),
        inputs_(make_trace_inputs<Real>(scene, view, settings, prepared, request.channels)),
        tiles_(make_tiles(view.width, view.height, traced_tile_size)),
        region_(asked_region(request, view.width, view.height)), tracer_(tile_tracer(scene, inputs_, plan_, prepared)) {
    inputs_.maps_spheres = !scene.textures->empty() || has(request.channels, Channel::uv);
    if (plan_.mode == SamplingMode::adaptive) request_.channels = request_.channels | Channel::ids;
    frame_ = empty_frame<Real>(view, request_);
    frame_.path = tracer_->path();
  }
  PictureTracer(const PictureTracer&) = delete;
  PictureTracer& operator=(const PictureTracer&) = delete;

  /// Draws the shadow maps that the picture asks for, and says whether it asks for any.
  bool draw_shadow_maps(const Scene& scene, Prepared& prepared) {
    add_shadow_maps(inputs_, scene, prepared, request_.priority, progress_);
    if (!inputs_.shadow_maps) return false;
    if (!frame_.shadow_map.empty()) raster::lay_out_maps(*inputs_.shadow_maps, frame_.shadow_map);
    return true;
  }

  Frame trace() {
    const bool adaptive = plan_.mode == SamplingMode::adaptive;
    const TileRect all{0, 0, frame_.width(), frame_.height()};
    // Adaptive sampling compares with the pixels just outside, too.
    const TileRect wanted = adaptive ? common_part(grown(region_), all) : region_;
    for_each_tile([&](std::size_t index, Counters& counters) {
      const TileRect part = common_part(tiles_[index], wanted);
      if (is_empty(part)) return false;
      tracer_->trace(tiles_[index], part, frame_, counters);
      store_sample_counts(part);
      return true;
    });
    if (adaptive) {
      subdivide();
      if (!ids_asked_) frame_.ids = {};
    }
    frame_.counters[Counter::triangles_degenerate] += inputs_.geometry->degenerate_triangles;
    if (const auto* octree = accelerator_as<Octree<Real>>(inputs_.accelerator))
      frame_.counters[Counter::octree_entries] += octree->entries.size();
    if (clears_outside(request_)) clear_outside(region_, frame_);
    return std::move(frame_);
  }

 private:
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

  void store_sample_counts(const TileRect& part) {
    if (frame_.samples.empty()) return;
    const bool many = plan_.mode == SamplingMode::many;
    for (int y = part.y0; y < part.y1; ++y)
      for (int x = part.x0; x < part.x1; ++x)
        frame_.samples.at(x, y) = many ? static_cast<std::uint32_t>(plan_.averaged()) : 1u;
  }

  /// The second pass of adaptive sampling: pixels whose first ray differs from a neighbour's are traced as with a fixed
  /// number of samples.
  void subdivide() {
    const Image<std::uint8_t> chosen = pixels_to_subdivide(frame_, region_, plan_);
    std::vector<std::uint64_t> nan_before(tiles_.size());
    for_each_tile([&](std::size_t index, Counters& counters) {
      std::vector<Vec2i> pixels;
      const TileRect part = common_part(tiles_[index], region_);
      for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x)
          if (chosen.at(x, y) != 0) pixels.push_back({x, y});
      for (const Vec2i& pixel : pixels) {
        nan_before[index] += has_nan(frame_.colour.at(pixel.x, pixel.y)) ? 1 : 0;
        if (!frame_.samples.empty()) frame_.samples.at(pixel.x, pixel.y) = static_cast<std::uint32_t>(plan_.samples);
      }
      tracer_->subdivide(tiles_[index], pixels, frame_, counters);
      counters[Counter::pixels_subdivided] += pixels.size();
      return !pixels.empty();
    });
    for (const std::uint64_t nan : nan_before) frame_.counters[Counter::nan_pixels] -= nan;
  }

  const Settings& settings_;
  RenderRequest request_;
  bool ids_asked_;
  SamplingPlan plan_;
  ParallelOptions parallel_;
  Progress& progress_;
  TraceInputs<Real> inputs_;
  std::vector<TileRect> tiles_;
  TileRect region_;
  std::unique_ptr<TileTracer> tracer_;
  Frame frame_;
};

template <class Real>
Frame render_in(const Scene& scene, const View& view, const Settings& settings, const SamplingPlan& plan,
                const RenderRequest& request, Prepared& prepared, Progress& progress) {
  const Timer preparing;
  PictureTracer<Real> tracer(scene, view, settings, plan, request, prepared, progress);
  const double prepared_ms = preparing.milliseconds();
  const Timer mapping;
  const bool has_maps = tracer.draw_shadow_maps(scene, prepared);
  const double mapped_ms = mapping.milliseconds();
  const Timer tracing;
  Frame frame = tracer.trace();
  frame.times.push_back({"prepare", prepared_ms});
  if (has_maps) frame.times.push_back({"shadow maps", mapped_ms});
  frame.times.push_back({"trace", tracing.milliseconds()});
  return frame;
}

}  // namespace

Frame render_planned(const Scene& scene, const View& view, const Settings& settings, const SamplingPlan& plan,
                     const RenderRequest& request, Prepared& prepared, Progress& progress) {
  switch (settings.precision) {
  case Precision::float32:
    return render_in<float>(scene, view, settings, plan, request, prepared, progress);
  case Precision::float64:
    return render_in<double>(scene, view, settings, plan, request, prepared, progress);
  }
  return {};
}

Frame render_traced(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                    Prepared& prepared, Progress& progress) {
  return render_planned(scene, view, settings, sampling_plan(settings), request, prepared, progress);
}

}  // namespace ps
