#include <algorithm>

#include <fmt/format.h>

#include "base/timer.h"
#include "frame/display_frame.h"
#include "frame/region.h"
#include "raster/base/fast_path.h"
#include "raster/clear/canvas_items.h"
#include "raster/fast/batch_drawer.h"
#include "raster/fast/fast_frame.h"
#include "raster/maps.h"
#include "raster/renderer.h"
#include "raster/replay/fragment_walk.h"
#include "record/recorder.h"

namespace ps {
namespace {

using namespace raster;

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

/// Draws one picture: what comes before the triangles, and triangles tile by tile.
template <class Real>
class Picture {
 public:
  Picture(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
          Prepared& prepared, Progress& progress)
      : scene_(scene), view_(view), request_(request),
        progress_(progress), parallel_{settings.threads, request.priority},
        frame_(make_frame(scene, view, settings, request.channels, Background::left_to_tiles)), stages_(frame_),
        inputs_(make_raster_inputs<Real>(scene, view, settings, request.channels, prepared)) {
    stages_.done("prepare");
    add_maps(inputs_, scene, view, {0, 0, view.width, view.height}, StencilNotes::none, prepared, parallel_, progress);
    if (inputs_.has_shadows() || inputs_.environment) stages_.done("shadow and environment maps");
    frame_.path = inputs_.path;
  }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  const RasterInputs<Real>& inputs() const { return inputs_; }
  Frame& frame() { return frame_; }
  Frame take() { return std::move(frame_); }

  using Sink = ClearSink<Real, CountingRecorder>;
  /// Draws the primitives of a tile, list by list, each by draw_list(sink, primitives, step).
  template <class DrawList>
  struct TileSink : Sink {
    const DrawList& draw_list;
    const Bins& bins;
    std::size_t tile;
    void step(const DrawStep& step, std::size_t) {
      for (std::size_t part = 0; part < bins.parts; ++part) draw_list(*this, bins.list(part, tile), step);
    }
  };

  template <class DrawList>
  void draw_tiles(const DrawList& draw_list) {
    const ScreenGeometry<Real> geometry = make_geometry(inputs_, {}, parallel_, progress_);
    stages_.done("vertices and clipping");
    const Bins bins = bin_primitives(inputs_, geometry, clear_tile_size, parallel_, progress_);
    stages_.done("sorting into tiles");

    const Settings& settings = inputs_.settings;
    const std::vector<TileRect> tiles = make_tiles(view_.width, view_.height, clear_tile_size);
    const TileRect region = asked_region(request_, view_.width, view_.height);
    std::vector<Counters> counters(tiles.size());
    parallel_for(static_cast<int>(tiles.size()), parallel_, progress_, [&](int index, int) {
      const auto i = static_cast<std::size_t>(index);
      if (is_empty(common_part(tiles[i], region))) return;
      CountingRecorder recorder;
      fill_background(scene_, tiles[i], frame_);
      Target<Real> target(frame_, tiles[i], settings, request_.channels);
      walk_fragments(inputs_, target, TileSink<DrawList>{{inputs_, geometry, target, recorder}, draw_list, bins, i});
      recorder.count(Counter::nan_pixels, target.count_nan_pixels());
      counters[i] = recorder.counters;
      finish_tile(request_, settings, frame_, tiles[i]);
    });
    frame_.counters += geometry.counters;
    store_map_pictures(inputs_, frame_);
    for (const Counters& tile : counters) frame_.counters += tile;
    frame_.counters[Counter::lines_drawn] += count_canvas_lines(scene_);
    if (clears_outside(request_)) clear_outside(region, frame_);
    stages_.done("fragments");
  }

  /// By the clear path.
  void draw_clearly() {
    draw_tiles([](Sink& sink, std::span<const PrimitiveRef> primitives, const DrawStep& step) {
      sink.draw(primitives, step);
    });
  }

 private:
  const Scene& scene_;
  const View& view_;
  const RenderRequest& request_;
  Progress& progress_;
  ParallelOptions parallel_;
  Frame frame_;
  Stages stages_;
  RasterInputs<Real> inputs_;
};

// What draws the picture is chosen here, once.
void draw_picture(Picture<float>& picture, const RenderRequest& request, Prepared& prepared, Progress& progress) {
  const RasterInputs<float>& inputs = picture.inputs();
  if (inputs.path.machinery == Machinery::clear) return picture.draw_clearly();
  const PackedTextures textures(inputs, prepared);
  const bool all_fit = std::all_of(inputs.surfaces.begin(), inputs.surfaces.end(),
                                   [&](const auto& surface) { return textures.has_room_for(surface); });
  const FastPath path = within_limits(inputs.path, {request.region.has_value(), !all_fit});
  picture.frame().path = path;
  if (path.machinery == Machinery::whole_frame)
    return draw_fast_frame(inputs, textures, request, picture.frame(), progress);
  const BatchKernels kernels = batch_kernels(inputs.settings.simd);
  picture.draw_tiles([&](Picture<float>::Sink& sink, std::span<const PrimitiveRef> primitives, const DrawStep&) {
    BatchDrawer(inputs, textures, kernels, sink.geometry, sink.target, sink.recorder).draw(primitives);
  });
}

}  // namespace

void require_rasterized_size(const View& view) {
  for (const int pixels : {view.width, view.height})
    if (pixels > guard_band)
      throw InputError(
          fmt::format("a width or height of {} pixels: the rasterizer draws at most {}", pixels, guard_band));
}

Frame render_rasterized(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                        Prepared& prepared, Progress& progress) {
  require_rasterized_size(view);
  switch (settings.precision) {
  case Precision::float32: {
    Picture<float> picture(scene, view, settings, request, prepared, progress);
    draw_picture(picture, request, prepared, progress);
    return picture.take();
  }
  case Precision::float64: {
    Picture<double> picture(scene, view, settings, request, prepared, progress);
    picture.draw_clearly();
    return picture.take();
  }
  }
  return {};
}

}  // namespace ps
