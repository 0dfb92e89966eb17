#include "raster/slow_picture.h"

#include <algorithm>
#include <cmath>

#include "frame/region.h"
#include "raster/clear/stepping_recorder.h"
#include "raster/maps.h"
#include "raster/renderer.h"
#include "raster/replay/fragment_walk.h"
#include "record/recorder.h"

namespace ps::raster {
namespace {

template <class Real>
std::uint32_t sequence_of(const ScreenGeometry<Real>& geometry, const PrimitiveRef& ref) {
  const Batch<Real>& batch = geometry.batches[ref.batch];
  return ref.is_line() ? batch.lines[ref.index].sequence : batch.triangles[ref.index].sequence;
}

}  // namespace

/// How far each walk has gone.
template <class Real>
struct SlowPicture<Real>::Progressed {
  std::size_t full_steps = 0;  ///< walks over all triangles
  std::size_t pieces = 0;      ///< of order_ that the next walk has drawn
  bool winners = false;        ///< deferred shading has been done
  std::size_t items = 0;       ///< on the canvas
  SlowMotion done;
  std::uint64_t total = 0;
  Bins all, some;  ///< the walks that are full, and the next one
};

template <class Real>
SlowPicture<Real>::SlowPicture(const Scene& scene, const View& view, const Settings& settings,
                               const RenderRequest& request, Prepared& prepared, Progress& progress)
    : scene_(scene), view_(view), request_(request), progress_(progress), parallel_{settings.threads, request.priority},
      inputs_(make_raster_inputs<Real>(scene, view, settings, request.channels, prepared)) {
  inputs_.path = {Machinery::clear, SurfaceShading::single, "slow motion shows the clear path"};
  add_maps(inputs_, scene, view, {0, 0, view.width, view.height}, StencilNotes::none, prepared, parallel_, progress);
  geometry_ = make_geometry(inputs_, {}, parallel_, progress);
  order_ = drawing_order(inputs_, geometry_);
  for (std::size_t i = 0; i < order_.size(); ++i)
    if (i + 1 == order_.size() || sequence_of(geometry_, order_[i]) != sequence_of(geometry_, order_[i + 1]))
      ends_.push_back(i + 1);
  steps_ = draw_steps(inputs_.settings, inputs_.lights.size());
}

template <class Real>
typename SlowPicture<Real>::Progressed SlowPicture<Real>::progressed(std::uint64_t at) const {
  Progressed p;
  const std::uint64_t each = ends_.size(), walks = each * steps_.size();
  const std::uint64_t shading = defers_shading(inputs_.settings) && each > 0 ? 1 : 0;
  p.total = walks + shading + scene_.canvas_items->size();
  const std::uint64_t done = std::min(at, p.total);
  p.done = {SlowUnit::triangles, done};
  p.full_steps = each == 0 ? steps_.size() : static_cast<std::size_t>(std::min(done, walks) / each);
  if (done < walks && done % each > 0) p.pieces = ends_[static_cast<std::size_t>(done % each) - 1];
  p.winners = done >= walks + shading;
  if (done > walks + shading) p.items = static_cast<std::size_t>(done - walks - shading);
  const auto bins = [&](std::size_t count) {
    return bin_primitives<Real>(inputs_, geometry_, std::span(order_).first(count), clear_tile_size, parallel_,
                                progress_);
  };
  if (p.full_steps > 0) p.all = bins(order_.size());
  p.some = bins(p.pieces);
  return p;
}

template <class Real>
void SlowPicture<Real>::draw_tile(const TileRect& tile, std::size_t index, const Progressed& done, Frame& frame,
                                  Counters& counters) {
  struct UpToHere : ClearSink<Real, CountingRecorder> {
    const Progressed& done;
    std::size_t index;  ///< of the tile
    void step(const DrawStep& step, std::size_t number) {
      if (number > done.full_steps) return;
      const Bins& bins = number < done.full_steps ? done.all : done.some;
      for (std::size_t part = 0; part < bins.parts; ++part) this->draw(bins.list(part, index), step);
    }
    void winners() {
      if (done.winners) ClearSink<Real, CountingRecorder>::winners();
    }
    void canvas() { draw_canvas_items(this->inputs, this->target, this->recorder, done.items); }
  };
  CountingRecorder recorder;
  Target<Real> target(frame, tile, inputs_.settings, request_.channels);
  walk_fragments(inputs_, target, UpToHere{{inputs_, geometry_, target, recorder}, done, index});
  recorder.count(Counter::nan_pixels, target.count_nan_pixels());
  counters = recorder.counters;
}

template <class Real>
SlowFrame SlowPicture<Real>::after_triangles(std::uint64_t at) {
  const Progressed done = progressed(at);
  SlowFrame slow;
  slow.state.done = done.done;
  slow.state.total = done.total;
  note_last(done, slow.state);
  slow.frame = make_frame(scene_, view_, inputs_.settings, request_.channels);
  const std::vector<TileRect> tiles = make_tiles(view_.width, view_.height, clear_tile_size);
  const TileRect region = asked_region(request_, view_.width, view_.height);
  std::vector<Counters> counters(tiles.size());
  parallel_for(static_cast<int>(tiles.size()), parallel_, progress_, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    if (!is_empty(common_part(tiles[i], region))) draw_tile(tiles[i], i, done, slow.frame, counters[i]);
  });
  slow.frame.path = inputs_.path;
  store_map_pictures(inputs_, slow.frame);
  for (const Counters& tile : counters) slow.frame.counters += tile;
  slow.frame.counters += geometry_.counters;
  if (request_.region) clear_outside(region, slow.frame);
  return slow;
}

template <class Real>
SlowFrame SlowPicture<Real>::after_fragments(std::uint64_t at, const Frame& whole) {
  SlowFrame slow;
  const std::optional<std::uint64_t> fragments = whole.counters.get(Counter::fragments);
  slow.state.total = fragments.value_or(0);
  slow.state.done = {SlowUnit::fragments, std::min(at, slow.state.total)};
  slow.frame = make_frame(scene_, view_, inputs_.settings, request_.channels);
  struct UntilTheNext : ClearSink<Real, SteppingRecorder> {
    const SlowPicture& picture;
    SlowFrame& slow;
    void step(const DrawStep& step, std::size_t number) {
      if (picture.steps_.size() > 1) slow.state.stage = picture.stage_name(number);
      constexpr std::size_t at_once = 64;  // triangles between two looks at whether to stop
      for (std::span<const PrimitiveRef> rest = picture.order_; !rest.empty();) {
        picture.progress_.check();
        const std::size_t count = std::min(at_once, rest.size());
        this->draw(rest.first(count), step);
        rest = rest.subspan(count);
      }
    }
    void winners() {  // without a stop: these fragments were counted when they were found
      CountingRecorder shading;
      shade_winners(this->inputs, this->geometry, this->target, shading);
      slow.frame.counters += shading.counters;
    }
  };
  SteppingRecorder recorder(slow.state.done.at);
  Target<Real> target(slow.frame, {0, 0, view_.width, view_.height}, inputs_.settings, request_.channels);
  try {
    walk_fragments(inputs_, target, UntilTheNext{{inputs_, geometry_, target, recorder}, *this, slow});
  } catch (const StepReached&) {
  }
  slow.frame.path = inputs_.path;
  store_map_pictures(inputs_, slow.frame);
  slow.frame.counters += recorder.counters;
  slow.frame.counters += geometry_.counters;
  if (const auto& last = recorder.last()) {
    slow.state.id = last->id;
    slow.state.outline.push_back(last->corners);
    Vec2d place(0);
    for (std::size_t k = 0; k < 3; ++k) place += last->corners[k] * last->weights_2d[k];
    const Vec2d column_row = place - inputs_.viewport.sample;
    slow.state.pixel = Vec2i(static_cast<int>(std::lround(column_row.x)), static_cast<int>(std::lround(column_row.y)));
  }
  if (request_.region) clear_outside(asked_region(request_, view_.width, view_.height), slow.frame);
  return slow;
}

template <class Real>
void SlowPicture<Real>::note_last(const Progressed& done, SlowState& state) const {
  const std::size_t each = ends_.size();
  if (done.done.at == 0) return;
  if (done.items > 0) {
    state.stage = "shapes on the canvas";
    return;
  }
  if (done.done.at > each * steps_.size()) {
    state.stage = "shading of what is visible";
    return;
  }
  const std::size_t last = static_cast<std::size_t>(done.done.at) - 1;
  if (steps_.size() > 1 || defers_shading(inputs_.settings)) state.stage = stage_name(last / each);
  const std::size_t begin = last % each == 0 ? 0 : ends_[last % each - 1];
  for (std::size_t i = begin; i < ends_[last % each]; ++i) note_triangle(order_[i], state);
}

template <class Real>
void SlowPicture<Real>::note_triangle(const PrimitiveRef& ref, SlowState& state) const {
  const Batch<Real>& batch = geometry_.batches[ref.batch];
  if (ref.is_line()) {
    const ScreenLine<Real>& line = batch.lines[ref.index];
    state.id = {inputs_.surfaces[line.surface].object, line.triangle};
    state.box = line.box;
    return;
  }
  const ScreenTriangle<Real>& triangle = batch.triangles[ref.index];
  state.id = {inputs_.surfaces[triangle.surface].object, triangle.triangle};
  const double unit = static_cast<double>(fixed_unit(inputs_.grid.subpixel_bits));
  std::array<Vec2d, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = {triangle.corners[k].x / unit, triangle.corners[k].y / unit};
  state.outline.push_back(corners);
}

template <class Real>
std::string_view SlowPicture<Real>::stage_name(std::size_t step) const {
  switch (steps_[step].stage) {
  case DrawStage::whole:
    return "";
  case DrawStage::depth_only:
    return "depth pass";
  case DrawStage::keep_winners:
    return "pass that finds what is visible";
  case DrawStage::shade_visible:
    return "shading pass";
  case DrawStage::one_light:
    return "pass of one light";
  }
  return "";
}

template class SlowPicture<float>;
template class SlowPicture<double>;

}  // namespace ps::raster
