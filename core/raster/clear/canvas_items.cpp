#include "raster/clear/canvas_items.h"

#include <algorithm>
#include <array>

#include "image/mixing.h"
#include "raster/clear/fragment_event.h"
#include "raster/clear/lines/walk_line.h"
#include "raster/guard_band.h"
#include "record/recorder.h"

namespace ps::raster {
namespace {

template <class Real>
Vec3<Real> blend_over(Blend blend, const Vec3<Real>& below, const Vec3<Real>& above) {
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

/// How one line is painted.
template <class Real>
struct LinePaint {
  Vec3<Real> colour{0, 0, 0};
  Blend blend = Blend::replace;
  PixelId id;  ///< of a wireframe's triangle; -1 for canvas items
};

bool contains(const TileRect& rect, const Vec2i& pixel) {
  return pixel.x >= rect.x0 && pixel.x < rect.x1 && pixel.y >= rect.y0 && pixel.y < rect.y1;
}

/// Walks the whole line from its own start, so that a stepped algorithm does not depend on the tile, and draws what
/// falls into the tile.
template <class Real, class Recorder>
void draw_line(const Pass<Real>& pass, const ScreenLine<Real>& line, const LinePaint<Real>& paint, Target<Real>& target,
               Recorder& recorder) {
  const int columns = pass.viewport.columns;
  const int rows = pass.viewport.rows;
  walk_line(pass.settings.line_algorithm, line.from, line.to, pass.settings.sample_position,
            [&](const Vec2i& book_name, int step) {
              const Vec2i pixel = array_pixel(book_name, columns, rows);
              if (!contains(target.rect(), pixel)) return;
              const Vec3<Real> before = target.colour(pixel.x, pixel.y);
              const Vec3<Real> after = blend_over(paint.blend, before, paint.colour);
              target.set_colour(pixel.x, pixel.y, after);
              recorder.count(Counter::pixels_written);
              if (target.wants(Channel::overdraw)) ++target.frame().overdraw.at(pixel.x, pixel.y);
              if (target.wants(Channel::ids) && paint.id.object >= 0)
                target.frame().ids.at(pixel.x, pixel.y) = paint.id;
              if (paint.blend != Blend::replace)
                recorder.event([&] { return WriteEvent{paint.id, Vec3d(before), Vec3d(paint.colour), Vec3d(after)}; });
              else
                recorder.event([&] {
                  const auto place = [&](const Vec2<Real>& p) {
                    return Vec2d(static_cast<double>(p.x) + columns / 2, rows - rows / 2 - static_cast<double>(p.y));
                  };
                  return LineEvent{paint.id, place(line.from), place(line.to), step, Vec3d(paint.colour)};
                });
            });
}

template <class Real, class Recorder>
void draw_canvas_segment(const Pass<Real>& pass, const Vec2d& from, const Vec2d& to, const LinePaint<Real>& paint,
                         Target<Real>& target, Recorder& recorder) {
  ScreenLine<Real> line;
  const bool visible =
      make_canvas_line(Vec2<Real>(from), Vec2<Real>(to), pass.viewport.columns, pass.viewport.rows, line);
  const TileRect& rect = target.rect();
  if (!visible || line.box.x0 >= rect.x1 || line.box.x1 <= rect.x0 || line.box.y0 >= rect.y1 || line.box.y1 <= rect.y0)
    return;
  draw_line(pass, line, paint, target, recorder);
}

/// One triangle of the fan that the guard band left of a canvas triangle.
template <class Real, class Recorder>
void fill_piece(const Pass<Real>& pass, const CanvasTriangle& item, const std::array<ClipVertex<Real>, 3>& corner,
                Target<Real>& target, Recorder& recorder) {
  std::array<FixedPoint, 3> fixed;
  std::array<Vec3<Real>, 3> colours;
  for (std::size_t k = 0; k < 3; ++k) {
    fixed[k] = to_fixed(Vec2<Real>(corner[k].position.x, corner[k].position.y), pass.grid.subpixel_bits);
    colours[k] = Vec3<Real>(0);
    for (int i = 0; i < 3; ++i) {
      const auto source = static_cast<std::size_t>(i);
      colours[k] += Vec3<Real>(item.colours[source] * item.h[source]) * corner[k].weights[i];
    }
  }
  const auto edges = make_edges(fixed, pass.grid);
  if (!edges) return;
  const Real inverse_area = Real(1) / static_cast<Real>(edges->area);
  const TileRect box = sample_box(fixed, pass.grid);
  const TileRect& rect = target.rect();
  for (int row = std::max(box.y0, rect.y0); row < std::min(box.y1, rect.y1); ++row)
    for (int column = std::max(box.x0, rect.x0); column < std::min(box.x1, rect.x1); ++column) {
      recorder.count(Counter::coverage_tests);
      if (target.wants(Channel::tests)) ++target.frame().tests.at(column, row);
      const auto values = edges->at(column, row);
      if (!edges->inside(values)) {
        if constexpr (Recorder::records)
          recorder.event([&] {
            return RejectEvent{{},
                               RejectReason::not_covered,
                               losing_edge(*edges, values),
                               edges_in_pixels(values, pass.grid.subpixel_bits)};
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
          event.corners[i] = canvas_pixels(fixed[i], pass.grid.subpixel_bits);
          event.tie_owned[i] = values[i] == 0;
          event.weights_2d[i] = event.weights[i] = static_cast<double>(w[i]);
        }
        event.edges = edges_in_pixels(values, pass.grid.subpixel_bits);
        return event;
      });
      recorder.event([&] { return WriteEvent{{}, Vec3d(before), Vec3d(colour), Vec3d(after)}; });
      target.set_colour(column, row, after);
    }
}

template <class Real, class Recorder>
void draw_item(const Pass<Real>& pass, const CanvasLine& item, Target<Real>& target, Recorder& recorder) {
  const LinePaint<Real> paint{Vec3<Real>(item.colour), item.blend, {}};
  draw_canvas_segment(pass, item.points[0], item.points[1], paint, target, recorder);
}

template <class Real, class Recorder>
void draw_item(const Pass<Real>& pass, const CanvasTriangle& item, Target<Real>& target, Recorder& recorder) {
  if (item.filled) {
    ClipPolygon<Real> polygon;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3<Real> weights(0);
      weights[static_cast<int>(k)] = 1;
      polygon.push({{static_cast<Real>(item.points[k].x) + pass.projection.centre.x,
                     pass.projection.centre.y - static_cast<Real>(item.points[k].y), 0},
                    weights});
    }
    bool split = false;
    if (cut_to_guard_band(polygon, split))
      for (int i = 1; i + 1 < polygon.size; ++i)
        fill_piece<Real>(pass, item,
                         {polygon.corners[0], polygon.corners[static_cast<std::size_t>(i)],
                          polygon.corners[static_cast<std::size_t>(i) + 1]},
                         target, recorder);
  }
  if (!item.outline) return;
  const LinePaint<Real> paint{Vec3<Real>(*item.outline), Blend::replace, {}};
  for (const auto& [from, to] : {std::array<std::size_t, 2>{0, 1}, {1, 2}, {0, 2}})
    draw_canvas_segment(pass, item.points[from], item.points[to], paint, target, recorder);
}

}  // namespace

template <class Real, class Recorder>
void draw_edge(const Pass<Real>& pass, const ScreenLine<Real>& line, Target<Real>& target, Recorder& recorder) {
  const Surface<Real>& surface = pass.surfaces[line.surface];
  const LinePaint<Real> paint{
      surface.material.colour, Blend::replace, {surface.object, surface.sphere ? 0 : line.triangle}};
  draw_line(pass, line, paint, target, recorder);
}

template <class Real, class Recorder>
void draw_canvas_items(const Pass<Real>& pass, Target<Real>& target, Recorder& recorder) {
  for (const CanvasItem& item : *pass.scene->canvas_items)
    std::visit([&](const auto& shape) { draw_item(pass, shape, target, recorder); }, item);
}

std::uint64_t count_canvas_lines(const Scene& scene) {
  std::uint64_t lines = 0;
  for (const CanvasItem& item : *scene.canvas_items) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    lines += !triangle ? 1u : triangle->outline ? 3u : 0u;
  }
  return lines;
}

#define PS_INSTANTIATE(Real, Recorder)                                                                                 \
  template void draw_edge(const Pass<Real>&, const ScreenLine<Real>&, Target<Real>&, Recorder&);                       \
  template void draw_canvas_items(const Pass<Real>&, Target<Real>&, Recorder&);
PS_INSTANTIATE(float, CountingRecorder)
PS_INSTANTIATE(float, PixelRecorder)
PS_INSTANTIATE(double, CountingRecorder)
PS_INSTANTIATE(double, PixelRecorder)
#undef PS_INSTANTIATE

}  // namespace ps::raster
