#include <algorithm>

#include <fmt/format.h>

#include "base/timer.h"
#include "frame/display_frame.h"
#include "frame/region.h"
#include "raster/canvas_items.h"
#include "raster/draw_primitives.h"
#include "raster/fast/fast_frame.h"
#include "raster/renderer.h"
#include "raster/shadow/fragment_shadows.h"
#include "raster/shadow/map_picture.h"
#include "record/recorder.h"

namespace ps {
namespace {

using namespace raster;

constexpr int tile_size = 64;

void require_side(int pixels) {
  if (pixels > guard_band)
    throw InputError(
        fmt::format("a width or height of {} pixels: the rasterizer draws at most {}", pixels, guard_band));
}

/// Notes how long each stage took.
class Stages {
 public:
  explicit Stages(Frame& frame) : frame_(frame) {}
  void done(std::string stage) {
    frame_.times.push_back({std::move(stage), timer_.milliseconds()});
    timer_ = Timer();
  }

 private:
  Frame& frame_;
  Timer timer_;
};

/// What draws the picture where whole tiles cannot be drawn at once.
FastPath drawn_by(const FastPath& allowed, const RenderRequest& request) {
  if (allowed.machinery != Machinery::whole_frame) return allowed;
  return {Machinery::fragment_batches, SurfaceShading::lanes,
          request.region ? "the tiled SIMD path needs the whole picture"
                         : "a texture is too large for the SIMD kernels"};
}

/// The channels that show maps and stencil buffers, and what those took.
template <class Real>
void store_map_pictures(const Pass<Real>& pass, Frame& frame) {
  if (pass.shadow_maps && !frame.shadow_map.empty()) lay_out_maps(*pass.shadow_maps, frame.shadow_map);
  if (pass.environment && !frame.environment.empty()) {
    const auto first =
        std::find_if(pass.environment->begin(), pass.environment->end(), [](const auto& m) { return m; });
    if (first != pass.environment->end()) lay_out_environment(**first, frame.environment);
  }
  if (!pass.stencil) return;
  frame.counters += pass.stencil->counters;
  if (frame.stencil.empty()) return;
  for (std::size_t light = 0; light < pass.stencil->counts.size(); ++light) {
    const int shown = pass.settings.light_shown;
    if (shown > 0 && static_cast<int>(light) + 1 != shown) continue;
    const Image<std::int32_t>& counts = pass.stencil->counts[light];
    for (std::size_t i = 0; i < counts.pixels().size(); ++i) frame.stencil.pixels()[i] += counts.pixels()[i];
  }
}

template <class Real>
Frame draw(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
           Prepared& prepared, Progress& progress) {
  Frame frame = make_frame(scene, view, settings, request.channels, Background::left_to_tiles);
  Stages stages(frame);
  const ParallelOptions parallel{settings.threads, request.priority};
  Pass<Real> pass = make_pass<Real>(scene, view, settings, request.channels, prepared);
  stages.done("prepare");
  add_maps(pass, scene, view, {0, 0, view.width, view.height}, StencilNotes::none, prepared, parallel, progress);
  if (pass.has_shadows() || pass.environment) stages.done("shadow and environment maps");
  if constexpr (std::is_same_v<Real, float>)
    if (!request.region && can_draw_fast(pass)) {
      draw_fast(pass, request, frame, progress);
      return frame;
    }
  frame.path = drawn_by(pass.path, request);
  const ScreenGeometry<Real> geometry = make_geometry(pass, {}, parallel, progress);
  stages.done("vertices and clipping");
  const auto bins = bin_primitives(pass, geometry, tile_size, parallel, progress);
  stages.done("sorting into tiles");

  const std::vector<TileRect> tiles = make_tiles(view.width, view.height, tile_size);
  const TileRect region = asked_region(request, view.width, view.height);
  std::vector<Counters> counters(tiles.size());
  const std::vector<DrawStep> steps = draw_steps(settings, pass.lights.size());
  parallel_for(static_cast<int>(tiles.size()), parallel, progress, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    if (is_empty(common_part(tiles[i], region))) return;
    CountingRecorder recorder;
    fill_background(scene, tiles[i], frame);
    Target<Real> target(frame, tiles[i], settings, request.channels);
    for (const DrawStep& step : steps)
      for (std::size_t part = 0; part < bins.parts; ++part)
        draw_primitives(pass, geometry, std::span<const PrimitiveRef>(bins.list(part, i)), step, target, recorder);
    if (defers_shading(settings)) shade_winners(pass, geometry, target, recorder);
    target.resolve();
    draw_canvas_items(pass, target, recorder);
    recorder.count(Counter::nan_pixels, target.count_nan_pixels());
    counters[i] = recorder.counters;
    finish_tile(request, settings, frame, tiles[i]);
  });
  frame.counters += geometry.counters;
  store_map_pictures(pass, frame);
  for (const Counters& tile : counters) frame.counters += tile;
  frame.counters[Counter::lines_drawn] += count_canvas_lines(scene);
  if (request.region) clear_outside(region, frame);
  stages.done("fragments");
  return frame;
}

}  // namespace

Frame render_rasterized(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                        Prepared& prepared, Progress& progress) {
  require_side(view.width);
  require_side(view.height);
  switch (settings.precision) {
  case Precision::float32:
    return draw<float>(scene, view, settings, request, prepared, progress);
  case Precision::float64:
    return draw<double>(scene, view, settings, request, prepared, progress);
  }
  return {};
}

}  // namespace ps
