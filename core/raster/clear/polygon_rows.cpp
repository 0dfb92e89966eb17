#include "raster/clear/polygon_rows.h"

#include <algorithm>
#include <cstdlib>

namespace ps::raster {
namespace {

/// a / b without its fraction, downwards; b > 0.
std::int64_t floor_of(std::int64_t a, std::int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// An edge and its walk. Whole numbers, so that no rounding error can move a row.
struct Edge {
  int number = 0;
  std::int64_t x0 = 0, y0 = 0, dx = 0, dy = 0, steps = 0;

  Edge(int index, const Vec2i& from, const Vec2i& to)
      : number(index), x0(from.x), y0(from.y), dx(std::int64_t{to.x} - from.x), dy(std::int64_t{to.y} - from.y),
        steps(std::max(std::abs(dx), std::abs(dy))) {}

  PolygonRowEnd at(std::int64_t step) const {
    const std::int64_t x = steps == 0 ? x0 : x0 + floor_of(dx * step, steps);
    return {static_cast<int>(x), number, step, steps};
  }
  /// The first and the last step of the walk that lie in row y, which the edge reaches.
  std::pair<std::int64_t, std::int64_t> steps_in_row(std::int64_t y) const {
    const std::int64_t rows = std::abs(dy), row = std::abs(y - y0);
    if (rows == 0) return {0, steps};
    if (rows == steps) return {row, row};
    // Upwards a row holds the steps that have passed it but not the next; downwards those that have not yet passed it.
    if (dy > 0) return {(row * steps + rows - 1) / rows, std::min(((row + 1) * steps - 1) / rows, steps)};
    return {row == 0 ? 0 : (row - 1) * steps / rows + 1, row * steps / rows};
  }
};

void widen(PolygonRow& row, const PolygonRowEnd& end) {
  if (end.x < row.left.x) row.left = end;
  if (end.x > row.right.x) row.right = end;
}

}  // namespace

std::vector<PolygonRow> polygon_rows(std::span<const Vec2i> vertices, RowRange range) {
  if (vertices.empty()) return {};
  const auto by_y = [](const Vec2i& a, const Vec2i& b) { return a.y < b.y; };
  const auto [lowest, highest] = std::minmax_element(vertices.begin(), vertices.end(), by_y);
  const int first = std::max(lowest->y, range.first), last = std::min(highest->y, range.last);
  if (first > last) return {};
  std::vector<PolygonRow> rows(static_cast<std::size_t>(last - first + 1));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].y = first + static_cast<int>(i);
    rows[i].left.x = std::numeric_limits<int>::max();
    rows[i].right.x = std::numeric_limits<int>::min();
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2i &from = vertices[i], &to = vertices[(i + 1) % vertices.size()];
    const Edge edge(static_cast<int>(i), from, to);
    const int top = std::max(std::min(from.y, to.y), first), bottom = std::min(std::max(from.y, to.y), last);
    for (int y = top; y <= bottom; ++y) {
      PolygonRow& row = rows[static_cast<std::size_t>(y - first)];
      const auto [begin, end] = edge.steps_in_row(y);
      widen(row, edge.at(begin));
      widen(row, edge.at(end));
    }
  }
  return rows;
}

}  // namespace ps::raster
