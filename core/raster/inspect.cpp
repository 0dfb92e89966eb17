#include <algorithm>
#include <set>

#include "frame/display_frame.h"
#include "frame/region.h"
#include "image/display.h"
#include "raster/assembly/near_pixel.h"
#include "raster/base/fragment_event.h"
#include "raster/clear/coverage/of_triangle.h"
#include "raster/clear/coverage/walk.h"
#include "raster/maps.h"
#include "raster/renderer.h"
#include "raster/replay/fragment_walk.h"

namespace ps {
namespace {

using namespace raster;

/// The pixel and those around it.
TileRect around(Vec2i pixel) { return grown(TileRect{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}); }

/// Do they share pixels? A triangle's box without width or height touches what lies on both sides of it.
bool touch(const TileRect& a, const TileRect& b) { return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1; }

/// The story's sink of a walk: draws the primitives that come near the pixel, and reports rejected triangles in their
/// turn.
template <class Real>
class StorySink : public ClearSink<Real, PixelRecorder> {
 public:
  StorySink(const ClearSink<Real, PixelRecorder>& sink, PixelStory& story)
      : ClearSink<Real, PixelRecorder>(sink), story_(story) {
    for (const Batch<Real>& batch : geometry.batches) {
      story.triangles_elsewhere += batch.elsewhere;
      rejected_.insert(rejected_.end(), batch.rejected.begin(), batch.rejected.end());
    }
    for (std::size_t i = 0; i < inputs.objects.size(); ++i)
      if (geometry.vertices[i].camera.empty()) story.triangles_elsewhere += inputs.objects[i].mesh->triangles.size();
    near_ = pick_near();
  }

  void step(const DrawStep& step, std::size_t number) {
    if (number > 0) return this->draw(near_, step);
    const bool in_order = !sorts_triangles(inputs.settings);
    if (!in_order) report_rejected(~std::uint32_t{0});
    for (std::size_t i = 0; i < near_.size();) {
      if (in_order) report_rejected(sequence(near_[i]));
      const std::size_t first = i;
      const std::uint64_t before = recorder.counters[Counter::pixels_written];
      for (; i < near_.size() && sequence(near_[i]) == sequence(near_[first]); ++i)
        this->draw(std::span<const PrimitiveRef>(&near_[i], 1), step);
      if (!fills(inputs.settings.draw) && recorder.counters[Counter::pixels_written] == before)
        report_untouched(line(near_[first]));
    }
    report_rejected(~std::uint32_t{0});
  }

 private:
  using ClearSink<Real, PixelRecorder>::inputs, ClearSink<Real, PixelRecorder>::geometry;
  using ClearSink<Real, PixelRecorder>::recorder;

  const ScreenTriangle<Real>& triangle(const PrimitiveRef& ref) const {
    return geometry.batches[ref.batch].triangles[ref.index];
  }
  const ScreenLine<Real>& line(const PrimitiveRef& ref) const { return geometry.batches[ref.batch].lines[ref.index]; }
  std::uint32_t sequence(const PrimitiveRef& ref) const {
    return ref.is_line() ? line(ref).sequence : triangle(ref).sequence;
  }

  /// A filled triangle is near when its box is. One of which only edges or vertices are drawn is near when its area is,
  /// or the box of the edge itself: without clipping, edges behind the camera are drawn upside down, away from it.
  bool is_near(const PrimitiveRef& ref) const {
    if (!ref.is_line()) return touch(triangle(ref).box, around(story_.pixel));
    const ScreenLine<Real>& edge = line(ref);
    if (touch(edge.box, around(story_.pixel))) return true;
    if (fills(inputs.settings.draw)) return false;
    const std::size_t object = inputs.surfaces[edge.surface].drawn;
    const MeshTriangle& mesh = inputs.objects[object].mesh->triangles[static_cast<std::size_t>(edge.triangle)];
    std::array<Vec3<Real>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = Vec3<Real>(geometry.vertices[object].camera[mesh.position[k]]);
    return near_pixel(inputs, corners, story_.pixel);
  }
  /// Reports a triangle near the pixel whose edges, or vertices, all miss it.
  void report_untouched(const ScreenLine<Real>& edge) {
    recorder.event([&] {
      const Surface<Real>& surface = inputs.surfaces[edge.surface];
      RejectEvent event;
      event.id = {surface.object, edge.triangle};
      event.reason = RejectReason::not_covered;
      event.detail = inputs.settings.draw == Draw::points ? "no vertex lies in it" : "no edge passes through it";
      name_by_object(surface.sphere, event);
      return event;
    });
  }

  /// The primitives near the pixel. Of the pieces that clipping made of one triangle only the one that covers the pixel
  /// stays, or the first if none does.
  std::vector<PrimitiveRef> pick_near() {
    std::vector<PrimitiveRef> near;
    std::set<std::uint32_t> near_triangles;
    std::set<std::uint32_t> covered;
    std::uint64_t triangles = 0;
    auto last = ~std::uint32_t{0};
    for (const PrimitiveRef& ref : drawing_order(inputs, geometry)) {
      if (sequence(ref) != last) ++triangles;
      last = sequence(ref);
      if (!is_near(ref)) continue;
      near.push_back(ref);
      near_triangles.insert(sequence(ref));
      if (!ref.is_line() && covers(triangle(ref))) covered.insert(sequence(ref));
    }
    story_.triangles_elsewhere += triangles - near_triangles.size();
    std::set<std::uint32_t> reported;
    std::erase_if(near, [&](const PrimitiveRef& ref) {
      if (ref.is_line() || covers(triangle(ref))) return false;
      return covered.count(sequence(ref)) > 0 || !reported.insert(sequence(ref)).second;
    });
    return near;
  }
  bool covers(const ScreenTriangle<Real>& candidate) const {
    const auto edges = make_edges(candidate.corners, inputs.grid);
    if (edges && inputs.grid.samples > 1) {
      const SubSampleEdges sub = make_sub_sample_edges(*edges, inputs.grid.subpixel_bits);
      const auto middle = edges->at(story_.pixel.x, story_.pixel.y);
      const auto samples = sample_pattern(inputs.grid.samples);
      return std::any_of(samples.begin(), samples.end(),
                         [&](const SubSample& sample) { return sub.inside(sub.at(middle, sample)); });
    }
    return edges && decide_sample<Real>(inputs.coverage, coverage_input(inputs, candidate, *edges), story_.pixel.x,
                                        story_.pixel.y)
                        .covered;
  }
  void report_rejected(std::uint32_t before) {
    for (; reported_ < rejected_.size() && rejected_[reported_].sequence < before; ++reported_)
      recorder.event([&] { return rejected_[reported_].event; });
  }

  PixelStory& story_;
  std::vector<PrimitiveRef> near_;
  std::vector<RejectedTriangle> rejected_;
  std::size_t reported_ = 0;
};

template <class Real>
PixelStory story_of(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
                    Progress& progress) {
  PixelStory story;
  story.pixel = pixel;
  story.renderer = Renderer::rasterizer;
  RasterInputs<Real> inputs = make_raster_inputs<Real>(scene, view, settings, Channel::none, prepared);
  add_maps(inputs, scene, view, {pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, StencilNotes::crossings, prepared,
           {settings.threads, {}}, progress);
  const ScreenGeometry<Real> geometry = make_geometry(inputs, pixel, {settings.threads, {}}, progress);
  const TileRect rect{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1};
  PixelRecorder recorder(pixel);
  recorder.counters = geometry.counters;
  Frame frame = make_frame(scene, {view.camera, 1, 1}, settings, Channel::none);
  Target<Real> target(frame, rect, settings, Channel::none, pixel);
  walk_fragments(inputs, target, StorySink<Real>({inputs, geometry, target, recorder}, story));
  story.linear = Vec3d(target.colour(pixel.x, pixel.y));
  const Rgb8 levels = display_pixel(story.linear, display_transform(settings));
  story.display = {levels.r, levels.g, levels.b};
  recorder.event([&] { return PixelEvent{story.linear, story.display}; });
  story.counters = recorder.counters;
  story.events = recorder.take();
  return story;
}

}  // namespace

PixelStory inspect_rasterized(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                              Prepared& prepared, Progress& progress) {
  switch (settings.precision) {
  case Precision::float32:
    return story_of<float>(scene, view, settings, pixel, prepared, progress);
  case Precision::float64:
    return story_of<double>(scene, view, settings, pixel, prepared, progress);
  }
  return {};
}

}  // namespace ps
