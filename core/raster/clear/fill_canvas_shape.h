#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include "image/mixing.h"
#include "raster/base/fragment_event.h"
#include "raster/base/guard_band.h"
#include "raster/base/raster_inputs.h"
#include "raster/base/target.h"
#include "raster/clear/canvas_outline.h"
#include "raster/clear/polygon_rows.h"
#include "record/recorder.h"

/// Filled triangles and convex polygons on the canvas (CGFS ch. 7; LAB 4).

namespace ps::raster {

/// The colour of a pixel after a shape is drawn over it. `inline` is a hint: without it GCC 12 calls the function for
/// each pixel, which takes 11 % more instructions for a fill.
template <class Real>
inline Vec3<Real> blend_over(Blend blend, const Vec3<Real>& below, const Vec3<Real>& above) {
  switch (blend) {
  case Blend::replace:
    return above;
  case Blend::additive:
    return mix_additive(below, above);
  case Blend::subtractive:
    return mix_subtractive(below, above);
  }
  return above;
}

/// Opens the event of a polygon as soon as one of its triangles has something to report.
template <class Recorder>
class PolygonNote {
 public:
  PolygonNote(Recorder& recorder, int item, const CanvasPolygon* polygon, const Vec2d& middle)
      : recorder_(recorder), item_(item), polygon_(polygon), middle_(middle) {}
  ~PolygonNote() {
    if (open_) recorder_.end();
  }
  PolygonNote(const PolygonNote&) = delete;
  PolygonNote& operator=(const PolygonNote&) = delete;

  void open() {
    if constexpr (Recorder::records) {
      if (open_ || !polygon_) return;
      open_ = true;
      recorder_.begin([&] {
        PolygonEvent event;
        event.item = item_;
        for (const CanvasVertex& v : polygon_->vertices)
          event.vertices.emplace_back(middle_.x + v.point.x, middle_.y - v.point.y);
        return event;
      });
    }
  }

 private:
  Recorder& recorder_;
  int item_;
  const CanvasPolygon* polygon_;  // nullptr: of a triangle, which needs no event around its own
  Vec2d middle_;
  bool open_ = false;
};

/// One triangle of the fan that the guard band left of a canvas triangle.
template <class Real, class Recorder>
void fill_piece(const RasterInputs<Real>& inputs, const CanvasTriangle& item,
                const std::array<ClipVertex<Real>, 3>& corner, Target<Real>& target, Recorder& recorder,
                PolygonNote<Recorder>& note) {
  std::array<FixedPoint, 3> fixed;
  std::array<Vec3<Real>, 3> colours;
  for (std::size_t k = 0; k < 3; ++k) {
    fixed[k] = to_fixed(Vec2<Real>(corner[k].position.x, corner[k].position.y), inputs.grid.subpixel_bits);
    colours[k] = Vec3<Real>(0);
    for (int i = 0; i < 3; ++i) {
      const auto source = static_cast<std::size_t>(i);
      colours[k] += Vec3<Real>(item.colours[source] * item.h[source]) * corner[k].weights[i];
    }
  }
  const auto edges = make_edges(fixed, inputs.grid);
  if (!edges) return;
  const Real inverse_area = Real(1) / static_cast<Real>(edges->area);
  const TileRect box = sample_box(fixed, inputs.grid);
  const TileRect& rect = target.rect();
  for (int row = std::max(box.y0, rect.y0); row < std::min(box.y1, rect.y1); ++row)
    for (int column = std::max(box.x0, rect.x0); column < std::min(box.x1, rect.x1); ++column) {
      note.open();
      recorder.count(Counter::coverage_tests);
      if (target.wants(Channel::tests)) ++target.frame().tests.at(column, row);
      const auto values = edges->at(column, row);
      if (!edges->inside(values)) {
        if constexpr (Recorder::records)
          recorder.event([&] {
            return RejectEvent{{},
                               RejectReason::not_covered,
                               losing_edge(*edges, values),
                               edges_in_pixels(values, inputs.grid.subpixel_bits)};
          });
        continue;
      }
      recorder.count(Counter::fragments);
      recorder.count(Counter::pixels_written);
      recorder.count(Counter::attributes_interpolated, 3);
      if (target.wants(Channel::overdraw)) ++target.frame().overdraw.at(column, row);
      std::array<Real, 3> w;
      for (std::size_t i = 0; i < 3; ++i) w[i] = static_cast<Real>(values[i]) * inverse_area;
      const Vec3<Real> colour = colours[0] * w[0] + colours[1] * w[1] + colours[2] * w[2];
      const Vec3<Real> before = target.colour(column, row);
      const Vec3<Real> after = blend_over(item.blend, before, colour);
      recorder.event([&] {
        FragmentEvent event;
        for (std::size_t i = 0; i < 3; ++i) {
          event.corners[i] = canvas_pixels(fixed[i], inputs.grid.subpixel_bits);
          event.weights_2d[i] = event.weights[i] = static_cast<double>(w[i]);
        }
        event.edges = edges_in_pixels(values, inputs.grid.subpixel_bits);
        event.tie_owned = {values[0] == 0, values[1] == 0, values[2] == 0};
        event.depth_stored = event.depth_new = 0;
        event.clipped_into = 1;
        return event;
      });
      recorder.event([&] { return WriteEvent{{}, Vec3d(before), Vec3d(colour), Vec3d(after)}; });
      target.set_colour(column, row, after);
    }
}

template <class Real, class Recorder>
void fill_triangle(const RasterInputs<Real>& inputs, const CanvasTriangle& item, Target<Real>& target,
                   Recorder& recorder, PolygonNote<Recorder>& note) {
  // The difference of two coordinates is still a number.
  constexpr double farthest = std::numeric_limits<Real>::max() / 4;
  const auto within = [farthest](double coordinate) {
    return static_cast<Real>(std::clamp(coordinate, -farthest, farthest));
  };
  ClipPolygon<Real> polygon;
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3<Real> weights(0);
    weights[static_cast<int>(k)] = 1;
    polygon.push({{within(item.points[k].x) + inputs.projection.centre.x,
                   inputs.projection.centre.y - within(item.points[k].y), 0},
                  weights});
  }
  bool split = false;
  if (!cut_to_guard_band(polygon, split)) return;
  for (int i = 1; i + 1 < polygon.size; ++i)
    fill_piece<Real>(inputs, item,
                     {polygon.corners[0], polygon.corners[static_cast<std::size_t>(i)],
                      polygon.corners[static_cast<std::size_t>(i) + 1]},
                     target, recorder, note);
}

/// Fills a convex shape as the lab does (LAB 4): the rows between its edges, colours interpolated along the edges and
/// then along each row. `index` is the shape's place among the items.
template <class Real, class Recorder>
void fill_rows(const CanvasOutline& outline, Blend blend, int index, Target<Real>& target, Recorder& recorder) {
  const TileRect& rect = target.rect();
  const auto colour_at = [&](const PolygonRowEnd& end) {
    const auto from = static_cast<std::size_t>(end.edge);
    const Vec3<Real> a(outline.colours[from]), b(outline.colours[(from + 1) % outline.colours.size()]);
    return a + (b - a) * end.template along<Real>();
  };
  for (const PolygonRow& row : polygon_rows(outline.pixels, {rect.y0, rect.y1 - 1})) {
    const Vec3<Real> first = colour_at(row.left), last = colour_at(row.right);
    const int columns = row.right.x - row.left.x;
    for (int column = std::max(row.left.x, rect.x0); column <= std::min(row.right.x, rect.x1 - 1); ++column) {
      recorder.count(Counter::fragments);
      recorder.count(Counter::pixels_written);
      recorder.count(Counter::attributes_interpolated, 3);
      if (target.wants(Channel::overdraw)) ++target.frame().overdraw.at(column, row.y);
      const Real along = columns == 0 ? Real(0) : static_cast<Real>(column - row.left.x) / static_cast<Real>(columns);
      const Vec3<Real> colour = first + (last - first) * along;
      const Vec3<Real> before = target.colour(column, row.y);
      const Vec3<Real> after = blend_over(blend, before, colour);
      recorder.begin([&] {
        PolygonEvent event;
        event.item = index;
        event.fill = CanvasFill::rows;
        for (const Vec2i& pixel : outline.pixels) event.vertices.emplace_back(pixel);
        event.row = PolygonRowSpan{row.left.x,
                                   row.right.x,
                                   {row.left.edge, row.right.edge},
                                   {static_cast<double>(row.left.template along<Real>()),
                                    static_cast<double>(row.right.template along<Real>())},
                                   {Vec3d(first), Vec3d(last)},
                                   static_cast<double>(along),
                                   Vec3d(colour)};
        return event;
      });
      recorder.event([&] { return WriteEvent{{}, Vec3d(before), Vec3d(colour), Vec3d(after)}; });
      recorder.end();
      target.set_colour(column, row.y, after);
    }
  }
}

template <class Real, class Recorder, class Shape>
void fill_shape(const RasterInputs<Real>& inputs, const Shape& shape, int index, Target<Real>& target,
                Recorder& recorder) {
  const Vec2i size{inputs.viewport.columns, inputs.viewport.rows};
  switch (inputs.settings.canvas_fill) {
  case CanvasFill::rows:
    return fill_rows(canvas_outline(shape, size, inputs.settings.sample_position), shape.blend, index, target,
                     recorder);
  case CanvasFill::edges: {
    const Vec2d middle(size.x / 2, size.y - size.y / 2);
    if constexpr (std::is_same_v<Shape, CanvasPolygon>) {
      PolygonNote<Recorder> note(recorder, index, &shape, middle);
      for (const CanvasTriangle& piece : triangles_of(shape)) fill_triangle(inputs, piece, target, recorder, note);
    } else {
      PolygonNote<Recorder> note(recorder, index, nullptr, middle);
      fill_triangle(inputs, shape, target, recorder, note);
    }
  }
  }
}

}  // namespace ps::raster
