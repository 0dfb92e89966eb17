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

/// One row of a triangle on the canvas by two rules, absent where a rule gives none.
struct CanvasRow {
  int y = 0;                           ///< row of the picture, from the top
  std::optional<ColumnSpan> outlined;  ///< between the pixels of its edges, all of them inside (LAB 4)
  std::optional<ColumnSpan>
      filled;  ///< the pixels that the rasterizer fills under the settings' fill rule (CGFS ch. 7)
  bool operator==(const CanvasRow&) const = default;
};

struct CanvasTriangleRows {
  int item = 0;                  ///< index into Scene::canvas_items
  std::array<Vec2i, 3> corners;  ///< the pixels of its vertices, array positions
  std::vector<CanvasRow> rows;   ///< from the top; only those that touch the picture
};

/// The rows of every filled triangle on the canvas that has the pixel (array position) by either rule, in the order in
/// which they are drawn. The outlined rows come from the same interpolation as the lab's, raster/clear/polygon_rows.h;
/// the filled ones from a picture of that triangle alone.
std::vector<CanvasTriangleRows> canvas_rows(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                                            Progress& progress);

/// "5..12" and "none", for tables.
std::string span_text(const std::optional<ColumnSpan>& span);

}  // namespace ps
