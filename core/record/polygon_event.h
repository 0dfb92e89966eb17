#pragma once
#include <array>
#include <optional>
#include <vector>

#include "math/vec.h"
#include "options/settings.h"

namespace ps {

/// The row of a shape on the canvas that holds the pixel, and what was interpolated: along the edges at both ends of
/// the row, then along the row (LAB 4).
struct PolygonRowSpan {
  int left = 0, right = 0;              ///< first and last column, array positions
  std::array<int, 2> edges{};           ///< on which the row begins and ends: from that vertex to the next
  std::array<double, 2> along_edges{};  ///< 0 at an edge's first vertex, 1 at its second
  std::array<Vec3d, 2> end_colours{};   ///< at the first and at the last column
  double along_row = 0;                 ///< the pixel's place: 0 at the first column, 1 at the last
  Vec3d colour{0, 0, 0};                ///< at the pixel
};

/// A filled shape of the canvas that reaches the pixel. Filled by rows, it has one that holds the pixel. A polygon that
/// is filled by edge functions has the triangles around its first vertex as children.
struct PolygonEvent {
  int item = 0;  ///< index among the items on the canvas
  CanvasFill fill = CanvasFill::edges;
  std::vector<Vec2d> vertices;  ///< by rows: array positions of their pixels; else pixels from the top left
  std::optional<PolygonRowSpan> row;
};

}  // namespace ps
