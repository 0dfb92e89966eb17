#include "raster/clear/canvas_items.h"

#include <algorithm>
#include <array>

#include "raster/clear/fill_canvas_shape.h"
#include "raster/clear/lines/walk_line.h"
#include "raster/clear/stepping_recorder.h"
#include "record/field_recorder.h"
#include "record/recorder.h"

namespace ps::raster {
namespace {

/// How one line is painted.
template <class Real>
struct LinePaint {
  Vec3<Real> colour{0, 0, 0};
  Blend blend = Blend::replace;
  PixelId id;  ///< of a wireframe's triangle; -1 for canvas items
};

/// Writes step `step` of a line into `pixel`, which lies in the tile.
template <class Real, class Recorder>
void draw_line_pixel(const RasterInputs<Real>& inputs, const ScreenLine<Real>& line, const LinePaint<Real>& paint,
                     const Vec2i& pixel, int step, Target<Real>& target, Recorder& recorder) {
  const Vec3<Real> before = target.colour(pixel.x, pixel.y);
  const Vec3<Real> after = blend_over(paint.blend, before, paint.colour);
  target.set_colour(pixel.x, pixel.y, after);
  recorder.count(Counter::pixels_written);
  if (target.wants(Channel::overdraw)) ++target.frame().overdraw.at(pixel.x, pixel.y);
  if (target.wants(Channel::ids) && paint.id.object >= 0) target.frame().ids.at(pixel.x, pixel.y) = paint.id;
  if (paint.blend != Blend::replace) {
    recorder.event([&] { return WriteEvent{paint.id, Vec3d(before), Vec3d(paint.colour), Vec3d(after)}; });
    return;
  }
  recorder.event([&] {
    const int columns = inputs.viewport.columns, rows = inputs.viewport.rows;
    const auto place = [&](const Vec2<Real>& p) {
      const int right = columns / 2, up = rows - rows / 2;  // of the canvas's centre, whole pixels
      return Vec2d(static_cast<double>(p.x) + right, up - static_cast<double>(p.y));
    };
    return LineEvent{paint.id, place(line.from), place(line.to), step, Vec3d(paint.colour)};
  });
}

/// Walks the whole line from its own start, so that a stepped algorithm does not depend on the tile, and draws what
/// falls into the tile.
template <class Real, class Recorder>
void draw_line(const RasterInputs<Real>& inputs, const ScreenLine<Real>& line, const LinePaint<Real>& paint,
               Target<Real>& target, Recorder& recorder) {
  walk_line(inputs.settings.line_algorithm, line.from, line.to, inputs.settings.sample_position,
            [&](const Vec2i& book_name, int step) {
              const Vec2i pixel = array_pixel(book_name, inputs.viewport.columns, inputs.viewport.rows);
              if (target.rect().contains(pixel.x, pixel.y))
                draw_line_pixel(inputs, line, paint, pixel, step, target, recorder);
            });
}

template <class Real, class Recorder>
void draw_canvas_segment(const RasterInputs<Real>& inputs, const Vec2d& from, const Vec2d& to,
                         const LinePaint<Real>& paint, Target<Real>& target, Recorder& recorder) {
  ScreenLine<Real> line;
  const bool visible =
      make_canvas_line(Vec2<Real>(from), Vec2<Real>(to), inputs.viewport.columns, inputs.viewport.rows, line);
  const TileRect& rect = target.rect();
  if (!visible || line.box.x0 >= rect.x1 || line.box.x1 <= rect.x0 || line.box.y0 >= rect.y1 || line.box.y1 <= rect.y0)
    return;
  draw_line(inputs, line, paint, target, recorder);
}

template <class Real, class Recorder>
void draw_item(const RasterInputs<Real>& inputs, const CanvasLine& item, int, Target<Real>& target,
               Recorder& recorder) {
  const LinePaint<Real> paint{Vec3<Real>(item.colour), item.blend, {}};
  draw_canvas_segment(inputs, item.points[0], item.points[1], paint, target, recorder);
}

template <class Real, class Recorder>
void draw_item(const RasterInputs<Real>& inputs, const CanvasTriangle& item, int index, Target<Real>& target,
               Recorder& recorder) {
  if (item.filled) fill_shape(inputs, item, index, target, recorder);
  if (!item.outline) return;
  const LinePaint<Real> paint{Vec3<Real>(*item.outline), Blend::replace, {}};
  for (const auto& [from, to] : {std::array<std::size_t, 2>{0, 1}, {1, 2}, {0, 2}})
    draw_canvas_segment(inputs, item.points[from], item.points[to], paint, target, recorder);
}

template <class Real, class Recorder>
void draw_item(const RasterInputs<Real>& inputs, const CanvasPolygon& item, int index, Target<Real>& target,
               Recorder& recorder) {
  if (item.filled) fill_shape(inputs, item, index, target, recorder);
  if (!item.outline) return;
  const LinePaint<Real> paint{Vec3<Real>(*item.outline), Blend::replace, {}};
  const std::size_t count = item.vertices.size();
  for (std::size_t i = 0; i < count; ++i)
    draw_canvas_segment(inputs, item.vertices[i].point, item.vertices[(i + 1) % count].point, paint, target, recorder);
}

}  // namespace

template <class Real, class Recorder>
void draw_edge(const RasterInputs<Real>& inputs, const ScreenLine<Real>& line, Target<Real>& target,
               Recorder& recorder) {
  const Surface<Real>& surface = inputs.surfaces[line.surface];
  Vec3<Real> colour = surface.material.colour;
  if (inputs.settings.draw == Draw::outlined) colour *= Real(0.75);  // of the author's program for CGFS ch. 12
  const LinePaint<Real> paint{colour, Blend::replace, {surface.object, surface.sphere ? 0 : line.triangle}};
  draw_line(inputs, line, paint, target, recorder);
}

template <class Real, class Recorder>
void draw_canvas_items(const RasterInputs<Real>& inputs, Target<Real>& target, Recorder& recorder, std::size_t most) {
  int index = 0;
  for (const CanvasItem& item : *inputs.scene->canvas_items) {
    if (static_cast<std::size_t>(index) >= most) return;
    std::visit([&](const auto& shape) { draw_item(inputs, shape, index, target, recorder); }, item);
    ++index;
  }
}

std::uint64_t count_canvas_lines(const Scene& scene) {
  std::uint64_t lines = 0;
  for (const CanvasItem& item : *scene.canvas_items)
    if (const auto* triangle = std::get_if<CanvasTriangle>(&item))
      lines += triangle->outline ? 3u : 0u;
    else if (const auto* polygon = std::get_if<CanvasPolygon>(&item))
      lines += polygon->outline ? polygon->vertices.size() : 0u;
    else
      ++lines;
  return lines;
}

// NOLINTBEGIN(bugprone-macro-parentheses): Real and Recorder are types
#define PS_INSTANTIATE(Real, Recorder)                                                                                 \
  template void draw_edge(const RasterInputs<Real>&, const ScreenLine<Real>&, Target<Real>&, Recorder&);               \
  template void draw_canvas_items(const RasterInputs<Real>&, Target<Real>&, Recorder&, std::size_t);
PS_INSTANTIATE(float, CountingRecorder)
PS_INSTANTIATE(float, PixelRecorder)
PS_INSTANTIATE(double, CountingRecorder)
PS_INSTANTIATE(double, PixelRecorder)
PS_INSTANTIATE(float, SteppingRecorder)
PS_INSTANTIATE(double, SteppingRecorder)
PS_INSTANTIATE(float, FieldRecorder)
PS_INSTANTIATE(double, FieldRecorder)
#undef PS_INSTANTIATE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace ps::raster
