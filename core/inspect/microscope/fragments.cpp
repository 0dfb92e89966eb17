#include "inspect/microscope/fragments.h"

#include <algorithm>
#include <cmath>

#include "frame/working_scene.h"
#include "inspect/microscope/texels.h"
#include "raster/clear/bins.h"
#include "raster/clear/canvas_outline.h"
#include "raster/clear/coverage/of_triangle.h"
#include "raster/clear/coverage/walk.h"
#include "raster/clear/fragment_event.h"
#include "raster/clear/geometry.h"
#include "raster/clear/multisample.h"
#include "raster/clear/near_pixel.h"
#include "raster/clear/polygon_rows.h"
#include "raster/clear/set_up_triangle.h"
#include "raster/guard_band.h"
#include "raster/replay/sample_winner.h"
#include "render/story/names.h"

namespace ps {
namespace {

using namespace raster;

constexpr const char* background = "the background";

/// A triangle that was copied out of the picture's geometry.
template <class Real>
struct NearTriangle {
  ScreenTriangle<Real> triangle;
  std::vector<Real> attributes;  ///< of its vertices, and what follows them (fragment.h)
  DepthPlane<Real> plane;        ///< only where depth is found by ray and plane
};

/// A filled triangle on the canvas, which is drawn after the scene.
struct NearCanvasTriangle {
  std::array<FixedPoint, 3> corners;
  int number = 0;  ///< among the triangles of the canvas
  std::optional<bool>
      rows;  ///< filled by rows: whether they hold the pixel and this is the first triangle of the shape
};

template <class Real>
class FragmentsIn final : public Microscope::Fragments {
 public:
  FragmentsIn(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
              Progress& progress)
      : working_(scene, view, settings, prepared),
        pass_(make_pass<Real>(working_.scene(), working_.view(), working_.settings(), Channel::none, prepared)),
        pixel_(pixel) {
    find_canvas_triangles(*scene.canvas_items);
    if (settings.draw != Draw::filled) return;
    const ScreenGeometry<Real> geometry = make_geometry(pass_, std::optional(pixel), {settings.threads, {}}, progress);
    for (const PrimitiveRef& ref : drawing_order(pass_, geometry)) {
      const Batch<Real>& batch = geometry.batches[ref.batch];
      const ScreenTriangle<Real>& triangle = batch.triangles[ref.index];
      if (!is_near(triangle.corners)) continue;
      const auto first = batch.attributes.begin() + static_cast<std::ptrdiff_t>(triangle.attributes);
      const auto most = std::min<std::ptrdiff_t>(batch.attributes.end() - first, most_scalars);
      near_.push_back({triangle, {first, first + most}, set_up_triangle(pass_, geometry, ref).plane});
    }
  }

  MicroReading read(const Vec2d& point) const override {
    const auto unit = static_cast<double>(fixed_unit(pass_.grid.subpixel_bits));
    CoverageGrid grid = pass_.grid;
    grid.samples = 1;
    grid.sample = {std::round(point.x * unit) / unit, std::round(point.y * unit) / unit};
    return read(grid, [&](const NearTriangle<Real>& near, const TriangleEdges& edges) {
      // Strategies of coverage are asked about the picture's own samples alone.
      if (pass_.grid.samples > 1 || grid.sample != pass_.grid.sample) return edges.inside(edges.at(pixel_.x, pixel_.y));
      return covers_sample(near, edges);
    });
  }

  std::vector<MicroSample> samples() const override {
    std::vector<MicroSample> samples;
    if (pass_.grid.samples == 1) {
      const MicroReading reading = read(pass_.grid.sample);
      samples.push_back({pass_.grid.sample, reading.seen != background, reading.seen, -1});
      return samples;
    }
    for (const SubSample& sample : sample_pattern(pass_.grid.samples)) samples.push_back(sample_of(sample));
    return samples;
  }

  bool near_canvas() const override { return !on_canvas_.empty(); }

 private:
  /// Vertices, constants of flat shading, and the vertices' weights of a piece that was cut.
  static constexpr std::ptrdiff_t most_scalars = 3 * static_cast<std::ptrdiff_t>(max_attributes) + 6 + 9;

  void find_canvas_triangles(const std::vector<CanvasItem>& items) {
    int number = 0;
    for (const CanvasItem& item : items) {
      std::optional<bool> rows = rows_hold_pixel(item);
      for (const CanvasItem& part : lines_and_triangles({item}))
        if (const auto* triangle = std::get_if<CanvasTriangle>(&part)) {
          find_canvas_triangle(*triangle, number++, rows);
          if (rows) rows = false;
        }
    }
  }
  void find_canvas_triangle(const CanvasTriangle& triangle, int number, std::optional<bool> rows) {
    NearCanvasTriangle near{{}, number, rows};
    bool in_reach = triangle.filled;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2<Real> at(static_cast<Real>(triangle.points[k].x) + pass_.projection.centre.x,
                          pass_.projection.centre.y - static_cast<Real>(triangle.points[k].y));
      in_reach = in_reach && std::max(std::abs(at.x), std::abs(at.y)) < static_cast<Real>(guard_band);
      if (in_reach) near.corners[k] = to_fixed(at, pass_.grid.subpixel_bits);
    }
    if (in_reach && is_near(near.corners) && make_edges(near.corners, pass_.grid)) on_canvas_.push_back(near);
  }
  /// Whether the rows of a shape hold the pixel; nothing if shapes are not filled by rows.
  std::optional<bool> rows_hold_pixel(const CanvasItem& item) const {
    if (pass_.settings.canvas_fill != CanvasFill::rows) return {};
    const Vec2i size{pass_.viewport.columns, pass_.viewport.rows};
    std::vector<Vec2i> vertices;
    if (const auto* triangle = std::get_if<CanvasTriangle>(&item))
      vertices = canvas_outline(*triangle, size, pass_.settings.sample_position).pixels;
    if (const auto* polygon = std::get_if<CanvasPolygon>(&item))
      vertices = canvas_outline(*polygon, size, pass_.settings.sample_position).pixels;
    const auto rows = polygon_rows(vertices, {pixel_.y, pixel_.y});
    return !rows.empty() && pixel_.x >= rows.front().left.x && pixel_.x <= rows.front().right.x;
  }

  bool is_near(const std::array<FixedPoint, 3>& corners) const {
    static_assert(micro_margin <= far_from_pixel);
    Vec2d low(1e30), high(-1e30);
    for (const FixedPoint& corner : corners) {
      const Vec2d at = in_pixel(corner);
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    // Sub-samples lie up to half a pixel around the sample, which may be the pixel's corner.
    const double reach = pass_.grid.samples > 1 ? 0.5 : 0;
    const Vec2d &at = pass_.grid.sample,
                first{std::min(-micro_margin, at.x - reach), std::min(-micro_margin, at.y - reach)};
    const Vec2d last{std::max(1 + micro_margin, at.x + reach), std::max(1 + micro_margin, at.y + reach)};
    return low.x <= last.x && low.y <= last.y && high.x >= first.x && high.y >= first.y;
  }
  Vec2d in_pixel(const FixedPoint& point) const {
    return canvas_pixels(point, pass_.grid.subpixel_bits) - Vec2d(pixel_);
  }

  TriangleSetup<Real> set_up(const NearTriangle<Real>& near, const TriangleEdges& edges) const {
    return {&near.triangle, &pass_.surfaces[near.triangle.surface],  near.attributes.data(),
            edges,          Real(1) / static_cast<Real>(edges.area), near.plane};
  }

  TriangleEdges edges_of(const NearTriangle<Real>& near, const CoverageGrid& grid) const {
    const auto edges = make_edges(near.triangle.corners, grid);
    PS_ASSERT(edges.has_value(), "triangles without area are left out by the assembly");
    return *edges;
  }
  bool covers_sample(const NearTriangle<Real>& near, const TriangleEdges& edges) const {
    const auto input = coverage_input(pass_, near.triangle, edges);
    return decide_sample<Real>(pass_.coverage, input, pixel_.x, pixel_.y).covered;
  }

  template <class Covers>
  MicroReading read(const CoverageGrid& grid, Covers covers) const {
    MicroReading reading;
    reading.point = grid.sample;
    SampleWinner<Real> seen(pass_);
    for (const NearTriangle<Real>& near : near_) {
      const TriangleSetup<Real> setup = set_up(near, edges_of(near, grid));
      const Fragment<Real> fragment =
          make_fragment(pass_, setup, pixel_.x, pixel_.y, setup.edges.at(pixel_.x, pixel_.y));
      MicroTriangle measured = measure(setup, fragment, grid);
      measured.covered = covers(near, setup.edges);
      measured.cut_out = SampleWinner<Real>::cut_out(pass_, setup, fragment);
      const Real depth = SampleWinner<Real>::depth(pass_, setup, fragment, grid.sample);
      if (pass_.settings.visibility == Visibility::depth_buffer) measured.depth = static_cast<double>(depth);
      if (measured.is_drawn()) seen.offer(static_cast<int>(reading.triangles.size()), depth);
      reading.triangles.push_back(std::move(measured));
    }
    reading.front = seen.winner();
    for (const NearCanvasTriangle& near : on_canvas_) {
      MicroTriangle measured = measure(near, grid);
      if (near.rows && grid.sample == pass_.grid.sample) measured.covered = *near.rows;
      if (measured.covered) reading.front = static_cast<int>(reading.triangles.size());  // over all before
      reading.triangles.push_back(std::move(measured));
    }
    reading.seen = background;
    if (reading.front < 0) return reading;
    const auto front = static_cast<std::size_t>(reading.front);
    reading.seen = reading.triangles[front].name;
    if (front < near_.size()) reading.texture = texture_of(near_[front], grid);
    return reading;
  }

  /// One of the samples of a multisampled pixel. Its triangles are cut out where they are at the pixel's centre.
  MicroSample sample_of(const SubSample& sample) const {
    const Vec2d place = place_in_pixel(sample, pass_.grid.sample);
    SampleWinner<Real> seen(pass_);
    const auto set_up_again = [&](const NearTriangle<Real>& near) { return set_up(near, edges_of(near, pass_.grid)); };
    for (std::size_t i = 0; i < near_.size(); ++i) {
      const TriangleSetup<Real> setup = set_up_again(near_[i]);
      const SubSampleEdges sub = make_sub_sample_edges(setup.edges, pass_.grid.subpixel_bits);
      const auto middle = setup.edges.at(pixel_.x, pixel_.y), values = sub.at(middle, sample);
      if (!sub.inside(values)) continue;
      if (SampleWinner<Real>::cut_out(pass_, setup, make_fragment(pass_, setup, pixel_.x, pixel_.y, middle))) continue;
      const Fragment<Real> fragment = sub_sample_fragment(pass_, setup, sub, pixel_.x, pixel_.y, values);
      seen.offer(static_cast<int>(i), SampleWinner<Real>::depth(pass_, setup, fragment, place));
    }
    std::string name(background);
    if (seen.winner() >= 0) name = name_of(set_up_again(near_[static_cast<std::size_t>(seen.winner())]));
    CoverageGrid grid = pass_.grid;
    grid.samples = 1;
    for (const NearCanvasTriangle& near : on_canvas_)
      if (const MicroTriangle measured = measure(near, grid); near.rows.value_or(measured.covered))
        name = measured.name;
    return {place, name != background, name, -1};
  }

  std::string name_of(const TriangleSetup<Real>& setup) const {
    const std::string name = primitive_name(*pass_.scene, event_id(setup));
    return setup.surface->sphere ? name + ", its triangle " + std::to_string(setup.triangle->triangle) : name;
  }

  ps::MicroTriangle measure(const TriangleSetup<Real>& setup, const Fragment<Real>& fragment,
                            const CoverageGrid& grid) const {
    const auto values = setup.edges.at(pixel_.x, pixel_.y);
    const auto weights = space_weights(pass_, setup, fragment);
    ps::MicroTriangle out;
    out.id = event_id(setup);
    out.name = name_of(setup);
    out.edges = edges_in_pixels(values, grid.subpixel_bits);
    out.back_face = setup.triangle->back_face;
    out.z = static_cast<double>(fragment.z);
    for (std::size_t i = 0; i < 3; ++i) {
      out.corners[i] = in_pixel(setup.triangle->corners[i]);
      out.ties[i] = values[i] == 0;
      out.owns[i] = setup.edges.threshold[i] < 0;
      out.weights_2d[i] = static_cast<double>(fragment.weights[i]);
      out.weights[i] = static_cast<double>(weights[i]);
      out.z_2d += out.weights_2d[i] * static_cast<double>(setup.triangle->z[i]);
    }
    const int slot = setup.surface->layout.uv;
    if (slot == AttributeLayout::absent) return out;
    out.uv = out.uv_2d = Vec2d(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Real* a = setup.attributes + i * static_cast<std::size_t>(setup.surface->layout.count) + slot;
      const double back = pass_.divides() ? static_cast<double>(setup.triangle->z[i]) : 1.0;
      const Vec2d corner = Vec2d(static_cast<double>(a[0]), static_cast<double>(a[1])) * back;
      *out.uv += out.weights[i] * corner;
      *out.uv_2d += out.weights_2d[i] * corner;
    }
    return out;
  }

  ps::MicroTriangle measure(const NearCanvasTriangle& near, const CoverageGrid& grid) const {
    const auto edges = make_edges(near.corners, grid);
    const auto values = edges->at(pixel_.x, pixel_.y);
    ps::MicroTriangle out;
    out.on_canvas = true;
    out.id = {-1, near.number};
    out.name = "triangle " + std::to_string(near.number) + " on the canvas";
    out.edges = edges_in_pixels(values, grid.subpixel_bits);
    out.covered = edges->inside(values);
    for (std::size_t i = 0; i < 3; ++i) {
      out.corners[i] = in_pixel(near.corners[i]);
      out.ties[i] = values[i] == 0;
      out.owns[i] = edges->threshold[i] < 0;
      out.weights_2d[i] = out.weights[i] =
          static_cast<double>(static_cast<Real>(values[i]) * (Real(1) / static_cast<Real>(edges->area)));
    }
    return out;
  }

  std::optional<MicroTexture> texture_of(const NearTriangle<Real>& near, const CoverageGrid& grid) const {
    const Surface<Real>& surface = pass_.surfaces[near.triangle.surface];
    const int index = surface.material.texture;
    if (surface.layout.uv == AttributeLayout::absent || !pass_.settings.textures || index < 0) return {};
    const TriangleSetup<Real> setup = set_up(near, edges_of(near, grid));
    const Fragment<Real> fragment = make_fragment(pass_, setup, pixel_.x, pixel_.y, setup.edges.at(pixel_.x, pixel_.y));
    const Vec2<Real> uv{interpolate(pass_, setup, fragment, surface.layout.uv),
                        interpolate(pass_, setup, fragment, surface.layout.uv + 1)};
    TexturePlace<Real> place{uv, uv};
    if (surface.layout.relief) {
      Silent silent;  // the microscope shows the colour's texels, not the relief's
      place.uv = relief_uv(pass_, setup, fragment, uv, shading_normal(pass_, setup, fragment), silent);
    }
    PixelRecorder recorder(pixel_);
    read_texture(pass_, setup, fragment, index, place, recorder);
    const std::vector<Event> events = recorder.take();
    const MipChain& chain = (*pass_.textures)[static_cast<std::size_t>(index)];
    const TextureDerivatives<Real> steps = uv_derivatives(pass_, setup, fragment, uv, *chain.base);
    return micro_texture(std::get<TextureEvent>(events.front().data), chain, pass_.settings.texture_wrap,
                         std::array{Vec2d(steps.dx), Vec2d(steps.dy)});
  }

  const WorkingScene working_;
  Pass<Real> pass_;
  Vec2i pixel_;
  std::vector<NearTriangle<Real>> near_;
  std::vector<NearCanvasTriangle> on_canvas_;
};

}  // namespace

std::unique_ptr<Microscope::Fragments> make_micro_fragments(const Scene& scene, const View& view,
                                                            const Settings& settings, Vec2i pixel, Prepared& prepared,
                                                            Progress& progress) {
  switch (settings.precision) {
  case Precision::float32:
    return std::make_unique<FragmentsIn<float>>(scene, view, settings, pixel, prepared, progress);
  case Precision::float64:
    return std::make_unique<FragmentsIn<double>>(scene, view, settings, pixel, prepared, progress);
  }
  return nullptr;
}

}  // namespace ps
