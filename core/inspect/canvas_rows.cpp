#include "inspect/canvas_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "options/renderer_kind.h"
#include "raster/clear/canvas_line.h"
#include "raster/clear/lines/walk_line.h"
#include "raster/clear/polygon_rows.h"
#include "render/render.h"

namespace ps {
namespace {

/// The pixel of a canvas point, as lines light it; nothing for a point so far outside that its rows would be endless.
std::optional<Vec2i> pixel_of_point(const Vec2d& point, const View& view, SamplePosition position) {
  constexpr double farthest = 1 << 16;  // pixels; no picture has a longer side than that many
  if (!(std::abs(point.x) <= farthest && std::abs(point.y) <= farthest)) return {};
  const Vec2d shifted = point + Vec2d(raster::odd_shift(view.width), raster::odd_shift(view.height));
  return raster::array_pixel(raster::book_pixel_at(shifted, position), view.width, view.height);
}

/// Columns of each row where the picture of this triangle alone has a fragment.
std::vector<std::optional<ColumnSpan>> filled_spans(const Scene& scene, CanvasTriangle triangle, const View& view,
                                                    Settings settings, Progress& progress) {
  settings.renderer = renderer_for(PictureWay::fragments);
  settings.draw = Draw::filled;
  triangle.outline.reset();
  Scene alone;
  alone.camera = scene.camera;
  alone.canvas_items.edit([&](std::vector<CanvasItem>& items) { items = {triangle}; });
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

bool holds(const CanvasTriangleRows& triangle, Vec2i pixel) {
  return std::any_of(triangle.rows.begin(), triangle.rows.end(), [&](const CanvasRow& row) {
    return row.y == pixel.y && (holds(row.outlined, pixel.x) || holds(row.filled, pixel.x));
  });
}

}  // namespace

std::vector<CanvasTriangleRows> canvas_rows(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                                            Progress& progress) {
  std::vector<CanvasTriangleRows> found;
  for (std::size_t i = 0; i < scene.canvas_items->size(); ++i) {
    const auto* triangle = std::get_if<CanvasTriangle>(&(*scene.canvas_items)[i]);
    if (triangle == nullptr || !triangle->filled) continue;
    CanvasTriangleRows rows;
    rows.item = static_cast<int>(i);
    bool near = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = pixel_of_point(triangle->points[k], view, settings.sample_position);
      near = near && corner.has_value();
      rows.corners[k] = corner.value_or(Vec2i{0, 0});
    }
    if (!near) continue;
    const auto [top, bottom] = std::minmax({rows.corners[0].y, rows.corners[1].y, rows.corners[2].y});
    const auto [left, right] = std::minmax({rows.corners[0].x, rows.corners[1].x, rows.corners[2].x});
    // Neither rule goes a whole pixel farther.
    if (pixel.y < top - 1 || pixel.y > bottom + 1 || pixel.x < left - 1 || pixel.x > right + 1) continue;
    const auto filled = filled_spans(scene, *triangle, view, settings, progress);
    const auto outlined = raster::polygon_rows(rows.corners);
    for (int y = std::max(top - 1, 0); y <= std::min(bottom + 1, view.height - 1); ++y) {
      CanvasRow row;
      row.y = y;
      if (y >= top && y <= bottom) {
        const raster::PolygonRow& one = outlined[static_cast<std::size_t>(y - top)];
        row.outlined = ColumnSpan{one.left, one.right};
      }
      row.filled = filled[static_cast<std::size_t>(y)];
      if (row.outlined || row.filled) rows.rows.push_back(row);
    }
    if (holds(rows, pixel)) found.push_back(std::move(rows));
  }
  return found;
}

std::string span_text(const std::optional<ColumnSpan>& span) {
  return span ? fmt::format("{}..{}", span->left, span->right) : "none";
}

}  // namespace ps
