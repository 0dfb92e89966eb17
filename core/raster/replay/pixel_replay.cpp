#include "raster/replay/pixel_replay.h"

#include <variant>

#include "raster/assembly/set_up_triangle.h"
#include "raster/base/depth_test.h"
#include "raster/replay/fragment_walk.h"
#include "record/recorder.h"

namespace ps::raster {
namespace {

TileRect only(Vec2i pixel) { return {pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}; }

/// The event among those of one triangle that says what became of its fragment; nullptr if there is none.
template <class Said>
const Said* said(const std::vector<Event>& events) {
  for (const Event& event : events)
    if (const auto* found = std::get_if<Said>(&event.data)) return found;
  return nullptr;
}

}  // namespace

template <class Real>
PixelReplay<Real>::PixelReplay(const RasterInputs<Real>& inputs, Vec2i pixel, const ParallelOptions& parallel,
                               Progress& progress, const IsNear& is_near)
    : inputs_(inputs), pixel_(pixel), geometry_(make_geometry(inputs, std::optional(pixel), parallel, progress)),
      batches_(static_cast<std::uint32_t>(geometry_.batches.size())) {
  for (const PrimitiveRef& ref : drawing_order(inputs, geometry_))
    if (!ref.is_line() && is_near(geometry_.batches[ref.batch].triangles[ref.index])) near_.push_back(ref);
  geometry_.batches.reserve(2 * geometry_.batches.size());
  for (std::size_t i = 0; i < batches_; ++i) {
    Batch<Real> whole = geometry_.batches[i];
    for (ScreenTriangle<Real>& triangle : whole.triangles) triangle.box = only(pixel);
    geometry_.batches.push_back(std::move(whole));
  }
}

template <class Real>
PrimitiveRef PixelReplay<Real>::ref(std::size_t number, Boxes boxes) const {
  PrimitiveRef ref = near_[number];
  if (boxes == Boxes::pixel) ref.batch += batches_;
  return ref;
}

/// Calls visit(number, events) for each triangle, in the walk that decides about visibility.
template <class Real>
template <class Visit>
void PixelReplay<Real>::draw(const RasterInputs<Real>& inputs, Boxes boxes, Visit&& visit) const {
  Frame frame = make_frame(*inputs.scene, {inputs.scene->camera, 1, 1}, inputs.settings, Channel::none);
  Target<Real> target(frame, only(pixel_), inputs.settings, Channel::none, pixel_);
  struct EachTriangle {
    const PixelReplay& replay;
    const RasterInputs<Real>& inputs;
    Boxes boxes;
    Target<Real>& target;
    Visit& visit;
    void step(const DrawStep& step, std::size_t) {
      if (!step.is_first()) return;
      for (std::size_t i = 0; i < replay.near_.size(); ++i) {
        PixelRecorder recorder(replay.pixel_);
        const PrimitiveRef ref = replay.ref(i, boxes);
        draw_primitives(inputs, replay.geometry_, std::span<const PrimitiveRef>(&ref, 1), step, target, recorder);
        visit(i, recorder.take());
      }
    }
    void winners() {}
    void canvas() {}
  };
  walk_fragments(inputs, target, EachTriangle{*this, inputs, boxes, target, visit});
}

template <class Real>
std::vector<ReplayedTriangle<Real>> PixelReplay<Real>::at(const Vec2d& point) const {
  const bool own = inputs_.grid.samples == 1 && point == inputs_.grid.sample;
  RasterInputs<Real> moved = inputs_;
  moved.settings.multisampling = moved.grid.samples = 1;
  moved.grid.sample = point;
  if (!own) moved.coverage = {};
  std::vector<ReplayedTriangle<Real>> triangles;
  draw(moved, own ? Boxes::own : Boxes::pixel, [&](std::size_t number, const std::vector<Event>& events) {
    ReplayedTriangle<Real> triangle;
    triangle.setup = set_up_triangle(moved, geometry_, near_[number]);
    triangle.setup.surface = &inputs_.surfaces[triangle.setup.triangle->surface];
    triangle.fragment =
        make_fragment(moved, triangle.setup, pixel_.x, pixel_.y, triangle.setup.edges.at(pixel_.x, pixel_.y));
    if (moved.settings.visibility == Visibility::depth_buffer)
      triangle.depth = moved.depth.encode(depth_value(moved, triangle.setup, triangle.fragment, point));
    const auto* fragment = said<FragmentEvent>(events);
    const auto* rejected = said<RejectEvent>(events);
    triangle.cut_out = rejected && rejected->reason == RejectReason::cut_out;
    triangle.covered = fragment || triangle.cut_out;
    triangle.passed = fragment && fragment->depth != FragmentEvent::Depth::failed;
    triangles.push_back(std::move(triangle));
  });
  return triangles;
}

template <class Real>
std::vector<int> PixelReplay<Real>::shown() const {
  std::vector<int> shown(static_cast<std::size_t>(inputs_.grid.samples), -1);
  draw(inputs_, Boxes::own, [&](std::size_t number, const std::vector<Event>& events) {
    const auto* fragment = said<FragmentEvent>(events);
    if (!fragment || fragment->depth == FragmentEvent::Depth::failed) return;
    const auto* written = said<CoverageEvent>(events);
    if (inputs_.grid.samples == 1)
      shown[0] = static_cast<int>(number);
    else if (written)
      for (const double sample : written->values) shown[static_cast<std::size_t>(sample)] = static_cast<int>(number);
  });
  return shown;
}

template <class Real>
TriangleSetup<Real> PixelReplay<Real>::set_up(int number) const {
  return set_up_triangle(inputs_, geometry_, near_[static_cast<std::size_t>(number)]);
}

template class PixelReplay<float>;
template class PixelReplay<double>;

}  // namespace ps::raster
