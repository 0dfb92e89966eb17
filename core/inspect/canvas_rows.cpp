#include "inspect/canvas_rows.h"

#include <algorithm>

#include <fmt/format.h>

#include "options/renderer_kind.h"
#include "raster/clear/canvas_outline.h"
#include "raster/clear/polygon_rows.h"
#include "render/render.h"

namespace ps {
namespace {

/// Columns of each row where the picture of this shape alone has a fragment.
template <class Shape>
std::vector<std::optional<ColumnSpan>> filled_spans(const Scene& scene, Shape shape, const View& view,
                                                    Settings settings, Progress& progress) {
  settings.renderer = renderer_for(PictureWay::fragments);
  settings.draw = Draw::filled;
  settings.canvas_fill = CanvasFill::edges;
  shape.outline.reset();
  Scene alone;
  alone.camera = scene.camera;
  alone.canvas_items.edit([&](std::vector<CanvasItem>& items) { items = {shape}; });
  RenderRequest wanted;
  wanted.channels = Channel::overdraw;
  Prepared prepared;
  const Frame frame = render(alone, view, settings, wanted, prepared, progress);
  std::vector<std::optional<ColumnSpan>> spans(static_cast<std::size_t>(view.height));
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      if (frame.overdraw.at(x, y) == 0) continue;
      auto& span = spans[static_cast<std::size_t>(y)];
      span = ColumnSpan{span ? span->left : x, x};
    }
  return spans;
}

bool holds(const std::optional<ColumnSpan>& span, int x) { return span && x >= span->left && x <= span->right; }

bool holds(const CanvasShapeRows& shape, Vec2i pixel) {
  return std::any_of(shape.rows.begin(), shape.rows.end(), [&](const CanvasRow& row) {
    return row.y == pixel.y && (holds(row.outlined, pixel.x) || holds(row.filled, pixel.x));
  });
}

Vec3d colour_at(const raster::CanvasOutline& outline, const raster::PolygonRowEnd& end) {
  const auto from = static_cast<std::size_t>(end.edge);
  const Vec3d &a = outline.colours[from], &b = outline.colours[(from + 1) % outline.colours.size()];
  return a + (b - a) * end.along<double>();
}

/// Could a row of the shape hold the pixel? Neither rule goes a whole pixel farther than the vertices' pixels.
bool is_near(const std::vector<Vec2i>& vertices, Vec2i pixel) {
  if (vertices.empty()) return false;
  Vec2i low = vertices.front(), high = low;
  for (const Vec2i& v : vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y)};
  }
  return pixel.x >= low.x - 1 && pixel.x <= high.x + 1 && pixel.y >= low.y - 1 && pixel.y <= high.y + 1;
}

template <class Shape>
std::optional<CanvasShapeRows> rows_of(const Scene& scene, const Shape& shape, const View& view,
                                       const Settings& settings, Vec2i pixel, Progress& progress) {
  const raster::CanvasOutline outline =
      raster::canvas_outline(shape, {view.width, view.height}, settings.sample_position);
  if (!is_near(outline.pixels, pixel)) return {};
  CanvasShapeRows found;
  found.vertices = outline.pixels;
  const auto filled = filled_spans(scene, shape, view, settings, progress);
  std::vector<CanvasRow> rows(static_cast<std::size_t>(view.height));
  for (const raster::PolygonRow& row : raster::polygon_rows(outline.pixels, {0, view.height - 1})) {
    CanvasRow& of = rows[static_cast<std::size_t>(row.y)];
    of.outlined = ColumnSpan{row.left.x, row.right.x};
    of.end_colours = {colour_at(outline, row.left), colour_at(outline, row.right)};
  }
  for (std::size_t y = 0; y < rows.size(); ++y) {
    rows[y].y = static_cast<int>(y);
    rows[y].filled = filled[y];
    if (rows[y].outlined || rows[y].filled) found.rows.push_back(rows[y]);
  }
  return found;
}

}  // namespace

std::vector<CanvasShapeRows> canvas_rows(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                                         Progress& progress) {
  std::vector<CanvasShapeRows> found;
  for (std::size_t i = 0; i < scene.canvas_items->size(); ++i) {
    const CanvasItem& item = (*scene.canvas_items)[i];
    std::optional<CanvasShapeRows> shape;
    if (const auto* triangle = std::get_if<CanvasTriangle>(&item); triangle && triangle->filled)
      shape = rows_of(scene, *triangle, view, settings, pixel, progress);
    if (const auto* polygon = std::get_if<CanvasPolygon>(&item); polygon && polygon->filled)
      shape = rows_of(scene, *polygon, view, settings, pixel, progress);
    if (!shape || !holds(*shape, pixel)) continue;
    shape->item = static_cast<int>(i);
    found.push_back(std::move(*shape));
  }
  return found;
}

std::string shape_name(const CanvasShapeRows& shape) {
  return shape.vertices.size() == 3 ? "triangle" : fmt::format("polygon with {} vertices", shape.vertices.size());
}

std::string span_text(const std::optional<ColumnSpan>& span) {
  return span ? fmt::format("{}..{}", span->left, span->right) : "none";
}

}  // namespace ps
