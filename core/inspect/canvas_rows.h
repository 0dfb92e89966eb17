#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "frame/view.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// Columns of one row of the picture, array positions, both included.
struct ColumnSpan {
  int left = 0, right = 0;
  bool operator==(const ColumnSpan&) const = default;
};

/// One row of a shape on the canvas by two rules, absent where a rule gives none.
struct CanvasRow {
  int y = 0;                           ///< row of the picture, from the top
  std::optional<ColumnSpan> outlined;  ///< between the pixels of its edges, all of them inside (LAB 4)
  /// What that rule interpolates along the edges for the first and the last of those columns.
  std::array<Vec3d, 2> end_colours{};
  std::optional<ColumnSpan> filled;  ///< the pixels that edge functions fill under the settings' fill rule (CGFS ch. 7)
  bool operator==(const CanvasRow&) const = default;
};

struct CanvasShapeRows {
  int item = 0;                 ///< index into Scene::canvas_items
  std::vector<Vec2i> vertices;  ///< the pixels of its vertices, array positions
  std::vector<CanvasRow> rows;  ///< from the top; only those that touch the picture
};

/// The rows of every filled triangle and polygon on the canvas that has the pixel (array position) by either rule, in
/// the order in which they are drawn. The outlined rows are those that `canvas-fill = rows` fills
/// (raster/clear/polygon_rows.h); the filled ones come from a picture of that shape alone.
std::vector<CanvasShapeRows> canvas_rows(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                                         Progress& progress);

/// "triangle" or "polygon with 5 vertices"
std::string shape_name(const CanvasShapeRows& shape);

/// "5..12" and "none", for tables.
std::string span_text(const std::optional<ColumnSpan>& span);

}  // namespace ps
