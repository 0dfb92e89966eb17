#include "raster/pixel_replay.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "frame/working_scene.h"
#include "raster/clear/canvas_items.h"
#include "raster/clear/draw_primitives.h"
#include "raster/clear/near_pixel.h"
#include "raster/clear/set_up_triangle.h"
#include "raster/replaced_fragment.h"
#include "raster/replay/sample_winner.h"
#include "raster/shadow/fragment_shadows.h"
#include "record/recorder.h"

namespace ps::raster {
namespace {

constexpr int replay_tile = 32;
constexpr std::uint32_t of_uncut = 1u << 31;  ///< in PrimitiveRef::batch: of the geometry without clipping

Settings replayed(Settings settings) {
  settings.multisampling = 1;
  settings.precision = Precision::float32;
  settings.draw = Draw::filled;
  return settings;
}

std::int64_t key_of(const PixelId& id) {
  return (std::int64_t{id.object} << 32) | static_cast<std::uint32_t>(id.triangle);
}

}  // namespace

struct PixelReplay::State {
  const WorkingScene working;
  const Scene& scene;
  const View& view;
  ParallelOptions parallel;
  Progress& progress;
  Pass<float> pass;
  Pass<float> given;  ///< the same with maps from elsewhere
  ScreenGeometry<float> geometry;
  Bins bins;
  std::size_t columns = 1;  ///< of tiles
  std::map<std::int64_t, std::vector<PrimitiveRef>> pieces;
  std::unique_ptr<ScreenGeometry<float>> uncut;  ///< made when first asked for
  std::map<std::int64_t, PrimitiveRef> uncut_pieces;

  State(const Scene& the_scene, const View& the_view, const Settings& settings, Prepared& prepared,
        Progress& the_progress)
      : working(the_scene, the_view, settings, prepared), scene(working.scene()),
        view(working.view()), parallel{settings.threads, WorkerPriority::normal}, progress(the_progress),
        pass(make_pass<float>(scene, view, replayed(working.settings()), Channel::none, prepared)) {
    add_maps(pass, scene, view, {0, 0, view.width, view.height}, StencilNotes::none, prepared, parallel, progress);
    geometry = make_geometry(pass, {}, parallel, progress);
    bins = bin_primitives(pass, geometry, replay_tile, parallel, progress);
    columns = static_cast<std::size_t>((view.width + replay_tile - 1) / replay_tile);
    for_all(geometry, [&](const PrimitiveRef& ref, const ScreenTriangle<float>& triangle) {
      pieces[key_of(id_of(triangle))].push_back(ref);
    });
    given = pass;
  }

  template <class Visit>
  static void for_all(const ScreenGeometry<float>& of, Visit&& visit) {
    for (std::size_t b = 0; b < of.batches.size(); ++b)
      for (std::size_t t = 0; t < of.batches[b].triangles.size(); ++t)
        visit(PrimitiveRef{static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(t)}, of.batches[b].triangles[t]);
  }
  PixelId id_of(const ScreenTriangle<float>& triangle) const {
    return {pass.surfaces[triangle.surface].object, triangle.triangle};
  }
  const ScreenGeometry<float>& geometry_of(const PrimitiveRef& ref) const {
    return (ref.batch & of_uncut) != 0 ? *uncut : geometry;
  }
  TriangleSetup<float> set_up(PrimitiveRef ref) const {
    const ScreenGeometry<float>& of = geometry_of(ref);
    ref.batch &= ~of_uncut;
    return set_up_triangle(pass, of, ref);
  }
  CoveringTriangle covering_of(const PrimitiveRef& ref, const TriangleSetup<float>& setup,
                               const Fragment<float>& fragment) const {
    return {ref, id_of(*setup.triangle), SampleWinner<float>::depth(pass, setup, fragment, pass.grid.sample),
            setup.triangle->cut};
  }
  void make_uncut() {
    if (uncut) return;
    Pass<float> open = pass;
    open.planes.clear();
    if (open.perspective())
      open.planes.push_back({{0, 0, 1}, -least_depth(open), RejectReason::behind_camera, "front"});
    uncut = std::make_unique<ScreenGeometry<float>>(make_geometry(open, {}, parallel, progress));
    for_all(*uncut, [&](PrimitiveRef ref, const ScreenTriangle<float>& triangle) {
      ref.batch |= of_uncut;
      uncut_pieces.emplace(key_of(id_of(triangle)), ref);
    });
  }
};

namespace {

/// The smallest distance of the sample from the three edges: pixels, below 0 outside.
double edge_distance(const TriangleSetup<float>& setup, const CoverageGrid& grid, Vec2i pixel) {
  const auto values = setup.edges.at(pixel.x, pixel.y);
  const auto unit = static_cast<double>(fixed_unit(grid.subpixel_bits));
  double least = INFINITY;
  for (std::size_t i = 0; i < 3; ++i) {
    // A step is the edge's extent times the units of a pixel.
    const double x = static_cast<double>(setup.edges.step_x[i]) / unit;
    const double y = static_cast<double>(setup.edges.step_y[i]) / unit;
    const double length = std::sqrt(x * x + y * y);
    least = std::min(least, static_cast<double>(values[i]) / length / unit);
  }
  return least;
}

}  // namespace

PixelReplay::PixelReplay(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                         Progress& progress)
    : state_(std::make_unique<State>(scene, view, settings, prepared, progress)) {}

PixelReplay::~PixelReplay() = default;

void PixelReplay::give_maps(std::shared_ptr<const ShadowMaps> shadows,
                            std::shared_ptr<const EnvironmentMaps> environment, const Image<std::uint32_t>& in_shadow) {
  Pass<float>& given = state_->given;
  if (given.shadow_maps && shadows) given.shadow_maps = std::move(shadows);
  if (given.environment && environment) given.environment = std::move(environment);
  if (!given.stencil || in_shadow.empty()) return;
  auto stencil = std::make_shared<Stencil>(*given.stencil);
  for (std::size_t light = 0; light < std::min<std::size_t>(stencil->counts.size(), 32); ++light)
    if (Image<std::int32_t>& counts = stencil->counts[light]; !counts.empty())
      std::transform(in_shadow.pixels().begin(), in_shadow.pixels().end(), counts.pixels().begin(),
                     [&](std::uint32_t bits) { return static_cast<std::int32_t>(bits >> light & 1u); });
  given.stencil = std::move(stencil);
}

std::vector<CoveringTriangle> PixelReplay::covering(Vec2i pixel) const {
  const State& s = *state_;
  const std::size_t tile =
      static_cast<std::size_t>(pixel.y / replay_tile) * s.columns + static_cast<std::size_t>(pixel.x / replay_tile);
  std::vector<CoveringTriangle> all;
  for (std::size_t part = 0; part < s.bins.parts; ++part)
    for (const PrimitiveRef& ref : s.bins.list(part, tile)) {
      const TileRect& box = s.geometry.batches[ref.batch].triangles[ref.index].box;
      if (pixel.x < box.x0 || pixel.x >= box.x1 || pixel.y < box.y0 || pixel.y >= box.y1) continue;
      const TriangleSetup<float> setup = s.set_up(ref);
      const auto values = setup.edges.at(pixel.x, pixel.y);
      if (!setup.edges.inside(values)) continue;
      const Fragment<float> fragment = make_fragment(s.pass, setup, pixel.x, pixel.y, values);
      if (SampleWinner<float>::cut_out(s.pass, setup, fragment)) continue;
      all.push_back(s.covering_of(ref, setup, fragment));
    }
  return all;
}

int PixelReplay::winner(const std::vector<CoveringTriangle>& covering) const {
  SampleWinner<float> seen(state_->pass);
  for (std::size_t i = 0; i < covering.size(); ++i) seen.offer(static_cast<int>(i), covering[i].depth);
  return seen.winner();
}

std::optional<CoveringTriangle> PixelReplay::nearest_piece(const PixelId& id, Vec2i pixel) const {
  const State& s = *state_;
  const auto found = s.pieces.find(key_of(id));
  if (found == s.pieces.end()) return {};
  std::optional<CoveringTriangle> nearest;
  double best = -INFINITY;
  for (const PrimitiveRef& ref : found->second) {
    const TriangleSetup<float> setup = s.set_up(ref);
    const double distance = edge_distance(setup, s.pass.grid, pixel);
    if (distance <= best) continue;
    best = distance;
    const auto values = setup.edges.at(pixel.x, pixel.y);
    nearest = s.covering_of(ref, setup, make_fragment(s.pass, setup, pixel.x, pixel.y, values));
  }
  return nearest;
}

std::optional<CoveringTriangle> PixelReplay::uncut(const PixelId& id, Vec2i pixel) {
  State& s = *state_;
  s.make_uncut();
  const auto found = s.uncut_pieces.find(key_of(id));
  if (found == s.uncut_pieces.end()) return {};
  const TriangleSetup<float> setup = s.set_up(found->second);
  const auto values = setup.edges.at(pixel.x, pixel.y);
  CoveringTriangle piece = s.covering_of(found->second, setup, make_fragment(s.pass, setup, pixel.x, pixel.y, values));
  piece.cut = true;
  return piece;
}

double PixelReplay::within_edges(const CoveringTriangle& triangle, Vec2i pixel) const {
  return edge_distance(state_->set_up(triangle.ref), state_->pass.grid, pixel);
}

GivenFragment PixelReplay::whole_triangle_at(const CoveringTriangle& triangle, Vec2i pixel) const {
  const State& s = *state_;
  return whole_triangle_values(s.pass, s.geometry_of(triangle.ref), s.set_up(triangle.ref), pixel);
}

Vec3f PixelReplay::with_canvas_items(Vec3f colour, Vec2i pixel) const {
  const State& s = *state_;
  if (s.scene.canvas_items->empty()) return colour;
  Frame frame;
  frame.colour = Image<Vec3f>(1, 1, colour);
  const TileRect rect{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1};
  Target<float> target(frame, rect, s.pass.settings, Channel::none, pixel);
  CountingRecorder recorder;
  draw_canvas_items(s.pass, target, recorder);
  return frame.colour.at(0, 0);
}

Vec3f PixelReplay::shade(const CoveringTriangle& triangle, Vec2i pixel, const GivenFragment& given,
                         ReplayMaps maps) const {
  const State& s = *state_;
  const TriangleSetup<float> setup = s.set_up(triangle.ref);
  const Pass<float>& pass = maps == ReplayMaps::given ? s.given : s.pass;
  return with_canvas_items(shade_replaced(pass, s.geometry_of(triangle.ref), setup, pixel, given), pixel);
}

Vec3f PixelReplay::background(Vec2i pixel) const { return with_canvas_items(Vec3f(state_->scene.background), pixel); }

}  // namespace ps::raster
