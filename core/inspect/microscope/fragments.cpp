#include "inspect/microscope/fragments.h"

#include <algorithm>
#include <cmath>

#include "frame/working_scene.h"
#include "inspect/microscope/texels.h"
#include "raster/assembly/near_pixel.h"
#include "raster/base/fragment_event.h"
#include "raster/base/guard_band.h"
#include "raster/base/multisample.h"
#include "raster/clear/canvas_outline.h"
#include "raster/clear/polygon_rows.h"
#include "raster/clear/shade_fragment.h"
#include "raster/replay/pixel_replay.h"
#include "render/story/names.h"

namespace ps {
namespace {

using namespace raster;

constexpr const char* background = "the background";

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
        inputs_(
            make_raster_inputs<Real>(working_.scene(), working_.view(), working_.settings(), Channel::none, prepared)),
        pixel_(pixel) {
    find_canvas_triangles(*scene.canvas_items);
    if (fills(settings.draw))
      replay_.emplace(inputs_, pixel, ParallelOptions{settings.threads, {}}, progress,
                      [this](const ScreenTriangle<Real>& triangle) { return is_near(triangle.corners); });
  }

  MicroReading read(const Vec2d& point) const override {
    const auto unit = static_cast<double>(fixed_unit(inputs_.grid.subpixel_bits));
    CoverageGrid grid = inputs_.grid;
    grid.samples = 1;
    grid.sample = {std::round(point.x * unit) / unit, std::round(point.y * unit) / unit};
    return read(grid);
  }

  std::vector<MicroSample> samples() const override {
    std::vector<MicroSample> samples;
    if (inputs_.grid.samples == 1) {
      const MicroReading reading = read(inputs_.grid);
      samples.push_back({inputs_.grid.sample, reading.seen != background, reading.seen, -1});
      return samples;
    }
    const auto pattern = sample_pattern(inputs_.grid.samples);
    const std::vector<int> shown = replay_ ? replay_->shown() : std::vector<int>(pattern.size(), -1);
    for (std::size_t i = 0; i < pattern.size(); ++i) {
      std::string name = shown[i] < 0 ? background : name_of(replay_->set_up(shown[i]));
      CoverageGrid grid = inputs_.grid;
      grid.samples = 1;
      for (const NearCanvasTriangle& near : on_canvas_)
        if (const MicroTriangle measured = measure(near, grid); near.rows.value_or(measured.covered))
          name = measured.name;
      samples.push_back({place_in_pixel(pattern[i], inputs_.grid.sample), name != background, name, -1});
    }
    return samples;
  }

  bool near_canvas() const override { return !on_canvas_.empty(); }

 private:
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
      const Vec2<Real> at(static_cast<Real>(triangle.points[k].x) + inputs_.projection.centre.x,
                          inputs_.projection.centre.y - static_cast<Real>(triangle.points[k].y));
      in_reach = in_reach && std::max(std::abs(at.x), std::abs(at.y)) < static_cast<Real>(guard_band);
      if (in_reach) near.corners[k] = to_fixed(at, inputs_.grid.subpixel_bits);
    }
    if (in_reach && is_near(near.corners) && make_edges(near.corners, inputs_.grid)) on_canvas_.push_back(near);
  }
  /// Whether the rows of a shape hold the pixel; nullopt if shapes are not filled by rows.
  std::optional<bool> rows_hold_pixel(const CanvasItem& item) const {
    if (inputs_.settings.canvas_fill != CanvasFill::rows) return {};
    const Vec2i size{inputs_.viewport.columns, inputs_.viewport.rows};
    std::vector<Vec2i> vertices;
    if (const auto* triangle = std::get_if<CanvasTriangle>(&item))
      vertices = canvas_outline(*triangle, size, inputs_.settings.sample_position).pixels;
    if (const auto* polygon = std::get_if<CanvasPolygon>(&item))
      vertices = canvas_outline(*polygon, size, inputs_.settings.sample_position).pixels;
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
    const double reach = inputs_.grid.samples > 1 ? 0.5 : 0;
    const Vec2d &at = inputs_.grid.sample,
                first{std::min(-micro_margin, at.x - reach), std::min(-micro_margin, at.y - reach)};
    const Vec2d last{std::max(1 + micro_margin, at.x + reach), std::max(1 + micro_margin, at.y + reach)};
    return low.x <= last.x && low.y <= last.y && high.x >= first.x && high.y >= first.y;
  }
  Vec2d in_pixel(const FixedPoint& point) const {
    return canvas_pixels(point, inputs_.grid.subpixel_bits) - Vec2d(pixel_);
  }

  MicroReading read(const CoverageGrid& grid) const {
    MicroReading reading;
    reading.point = grid.sample;
    std::vector<ReplayedTriangle<Real>> triangles;
    if (replay_) triangles = replay_->at(grid.sample);
    for (const ReplayedTriangle<Real>& triangle : triangles) {
      if (triangle.passed) reading.front = static_cast<int>(reading.triangles.size());
      reading.triangles.push_back(measure(triangle, grid));
    }
    for (const NearCanvasTriangle& near : on_canvas_) {
      MicroTriangle measured = measure(near, grid);
      if (near.rows && grid.sample == inputs_.grid.sample) measured.covered = *near.rows;
      if (measured.covered) reading.front = static_cast<int>(reading.triangles.size());  // over all before
      reading.triangles.push_back(std::move(measured));
    }
    reading.seen = background;
    if (reading.front < 0) return reading;
    const auto front = static_cast<std::size_t>(reading.front);
    reading.seen = reading.triangles[front].name;
    if (front < triangles.size()) reading.texture = texture_of(triangles[front]);
    return reading;
  }

  std::string name_of(const TriangleSetup<Real>& setup) const {
    const std::string name = primitive_name(*inputs_.scene, event_id(setup));
    return setup.surface->sphere ? name + ", its triangle " + std::to_string(setup.triangle->triangle) : name;
  }

  ps::MicroTriangle measure(const ReplayedTriangle<Real>& replayed, const CoverageGrid& grid) const {
    const TriangleSetup<Real>& setup = replayed.setup;
    const Fragment<Real>& fragment = replayed.fragment;
    const auto values = setup.edges.at(pixel_.x, pixel_.y);
    const auto weights = space_weights(inputs_, setup, fragment);
    ps::MicroTriangle out;
    out.id = event_id(setup);
    out.name = name_of(setup);
    out.face = face_data(*inputs_.scene, out.id);
    out.edges = edges_in_pixels(values, grid.subpixel_bits);
    out.back_face = setup.triangle->back_face;
    out.z = static_cast<double>(fragment.z);
    if (replayed.depth) out.depth = static_cast<double>(*replayed.depth);
    out.covered = replayed.covered;
    out.cut_out = replayed.cut_out;
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
      const double back = inputs_.divides() ? static_cast<double>(setup.triangle->z[i]) : 1.0;
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

  std::optional<MicroTexture> texture_of(const ReplayedTriangle<Real>& replayed) const {
    const TriangleSetup<Real>& setup = replayed.setup;
    const Fragment<Real>& fragment = replayed.fragment;
    const Surface<Real>& surface = *setup.surface;
    const int index = surface.material.texture;
    if (surface.layout.uv == AttributeLayout::absent || !inputs_.settings.textures || index < 0) return {};
    const Vec2<Real> uv{interpolate(inputs_, setup, fragment, surface.layout.uv),
                        interpolate(inputs_, setup, fragment, surface.layout.uv + 1)};
    TexturePlace<Real> place{uv, uv};
    if (surface.layout.relief) {
      Silent silent;  // the microscope shows the colour's texels, not the relief's
      place.uv = relief_uv(inputs_, setup, fragment, uv, shading_normal(inputs_, setup, fragment), silent);
    }
    PixelRecorder recorder(pixel_);
    read_texture(inputs_, setup, fragment, index, place, recorder);
    const std::vector<Event> events = recorder.take();
    const MipChain& chain = (*inputs_.textures)[static_cast<std::size_t>(index)];
    const TextureDerivatives<Real> steps = uv_derivatives(inputs_, setup, fragment, uv, *chain.base);
    return micro_texture(std::get<TextureEvent>(events.front().data), chain, inputs_.settings.texture_wrap,
                         std::array{Vec2d(steps.dx), Vec2d(steps.dy)});
  }

  const WorkingScene working_;
  RasterInputs<Real> inputs_;
  Vec2i pixel_;
  std::optional<PixelReplay<Real>> replay_;  ///< without, no triangles are filled
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
