#include <algorithm>
#include <set>

#include "frame/display_frame.h"
#include "frame/region.h"
#include "image/display.h"
#include "raster/clear/canvas_items.h"
#include "raster/clear/coverage/of_triangle.h"
#include "raster/clear/coverage/walk.h"
#include "raster/clear/draw_primitives.h"
#include "raster/clear/fragment_event.h"
#include "raster/clear/near_pixel.h"
#include "raster/renderer.h"
#include "raster/shadow/fragment_shadows.h"

namespace ps {
namespace {

using namespace raster;

/// The pixel and those around it.
TileRect around(Vec2i pixel) { return grown(TileRect{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}); }

/// Do they share pixels? A triangle's box without width or height touches what lies on both sides of it.
bool touch(const TileRect& a, const TileRect& b) { return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1; }

/// Goes through all primitives in drawing order and draws those that come near the pixel, reporting rejected triangles
/// in their turn.
template <class Real>
class PixelWalk {
 public:
  PixelWalk(const Pass<Real>& pass, const ScreenGeometry<Real>& geometry, Vec2i pixel, PixelStory& story)
      : pass_(pass), geometry_(geometry), pixel_(pixel), story_(story) {
    for (const Batch<Real>& batch : geometry.batches) {
      story.triangles_elsewhere += batch.elsewhere;
      rejected_.insert(rejected_.end(), batch.rejected.begin(), batch.rejected.end());
    }
    for (std::size_t i = 0; i < pass.objects.size(); ++i)
      if (geometry.vertices[i].camera.empty()) story.triangles_elsewhere += pass.objects[i].mesh->triangles.size();
  }

  void draw(Target<Real>& target, PixelRecorder& recorder) {
    const std::vector<PrimitiveRef> near = pick_near();
    const std::vector<DrawStep> steps = draw_steps(pass_.settings, pass_.lights.size());
    const bool in_order = pass_.settings.visibility != Visibility::painter;
    if (!in_order) report_rejected(recorder, ~std::uint32_t{0});
    for (std::size_t i = 0; i < near.size();) {
      if (in_order) report_rejected(recorder, sequence(near[i]));
      const std::size_t first = i;
      const std::uint64_t before = recorder.counters[Counter::pixels_written];
      for (; i < near.size() && sequence(near[i]) == sequence(near[first]); ++i)
        draw_primitives(pass_, geometry_, std::span<const PrimitiveRef>(&near[i], 1), steps.front(), target, recorder);
      if (!filled() && recorder.counters[Counter::pixels_written] == before)
        report_untouched(recorder, line(near[first]));
    }
    report_rejected(recorder, ~std::uint32_t{0});
    for (std::size_t s = 1; s < steps.size(); ++s)
      draw_primitives(pass_, geometry_, std::span<const PrimitiveRef>(near), steps[s], target, recorder);
    if (defers_shading(pass_.settings)) shade_winners(pass_, geometry_, target, recorder);
    target.resolve();
    draw_canvas_items(pass_, target, recorder);
  }

 private:
  bool filled() const { return pass_.settings.draw == Draw::filled; }
  const ScreenTriangle<Real>& triangle(const PrimitiveRef& ref) const {
    return geometry_.batches[ref.batch].triangles[ref.index];
  }
  const ScreenLine<Real>& line(const PrimitiveRef& ref) const { return geometry_.batches[ref.batch].lines[ref.index]; }
  std::uint32_t sequence(const PrimitiveRef& ref) const {
    return filled() ? triangle(ref).sequence : line(ref).sequence;
  }

  /// A filled triangle is near when its box is. One of which only edges or vertices are drawn is near when its area is,
  /// or the box of the edge itself: without clipping, edges behind the camera are drawn upside down, away from it.
  bool is_near(const PrimitiveRef& ref) const {
    if (filled()) return touch(triangle(ref).box, around(pixel_));
    const ScreenLine<Real>& edge = line(ref);
    if (touch(edge.box, around(pixel_))) return true;
    const std::size_t object = pass_.surfaces[edge.surface].drawn;
    const MeshTriangle& mesh = pass_.objects[object].mesh->triangles[static_cast<std::size_t>(edge.triangle)];
    std::array<Vec3<Real>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = Vec3<Real>(geometry_.vertices[object].camera[mesh.position[k]]);
    return near_pixel(pass_, corners, pixel_);
  }
  /// Reports a triangle near the pixel whose edges, or vertices, all miss it.
  void report_untouched(PixelRecorder& recorder, const ScreenLine<Real>& edge) const {
    recorder.event([&] {
      const Surface<Real>& surface = pass_.surfaces[edge.surface];
      RejectEvent event;
      event.id = {surface.object, edge.triangle};
      event.reason = RejectReason::not_covered;
      event.detail = pass_.settings.draw == Draw::points ? "no vertex lies in it" : "no edge passes through it";
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
    for (const PrimitiveRef& ref : drawing_order(pass_, geometry_)) {
      if (sequence(ref) != last) ++triangles;
      last = sequence(ref);
      if (!is_near(ref)) continue;
      near.push_back(ref);
      near_triangles.insert(sequence(ref));
      if (filled() && covers(triangle(ref))) covered.insert(sequence(ref));
    }
    story_.triangles_elsewhere += triangles - near_triangles.size();
    if (!filled()) return near;
    std::set<std::uint32_t> reported;
    std::erase_if(near, [&](const PrimitiveRef& ref) {
      if (covers(triangle(ref))) return false;
      return covered.count(sequence(ref)) > 0 || !reported.insert(sequence(ref)).second;
    });
    return near;
  }
  bool covers(const ScreenTriangle<Real>& candidate) const {
    const auto edges = make_edges(candidate.corners, pass_.grid);
    if (edges && pass_.grid.samples > 1) {
      const SubSampleEdges sub = make_sub_sample_edges(*edges, pass_.grid.subpixel_bits);
      const auto middle = edges->at(pixel_.x, pixel_.y);
      const auto samples = sample_pattern(pass_.grid.samples);
      return std::any_of(samples.begin(), samples.end(),
                         [&](const SubSample& sample) { return sub.inside(sub.at(middle, sample)); });
    }
    return edges &&
           decide_sample<Real>(pass_.coverage, coverage_input(pass_, candidate, *edges), pixel_.x, pixel_.y).covered;
  }
  void report_rejected(PixelRecorder& recorder, std::uint32_t before) {
    for (; reported_ < rejected_.size() && rejected_[reported_].sequence < before; ++reported_)
      recorder.event([&] { return rejected_[reported_].event; });
  }

  const Pass<Real>& pass_;
  const ScreenGeometry<Real>& geometry_;
  Vec2i pixel_;
  PixelStory& story_;
  std::vector<RejectedTriangle> rejected_;
  std::size_t reported_ = 0;
};

template <class Real>
PixelStory story_of(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
                    Progress& progress) {
  PixelStory story;
  story.pixel = pixel;
  story.renderer = Renderer::rasterizer;
  Pass<Real> pass = make_pass<Real>(scene, view, settings, Channel::none, prepared);
  add_maps(pass, scene, view, {pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, StencilNotes::crossings, prepared,
           {settings.threads, {}}, progress);
  const ScreenGeometry<Real> geometry = make_geometry(pass, pixel, {settings.threads, {}}, progress);
  const TileRect rect{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1};
  PixelRecorder recorder(pixel);
  recorder.counters = geometry.counters;
  Frame frame = make_frame(scene, {view.camera, 1, 1}, settings, Channel::none);
  Target<Real> target(frame, rect, settings, Channel::none, pixel);
  PixelWalk<Real>(pass, geometry, pixel, story).draw(target, recorder);
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
