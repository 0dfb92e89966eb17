#include "raster/clear/polygon_rows.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace ps::raster {
namespace {

/// a + (b - a) * step / steps without its fraction, in whole numbers: no rounding error can move a row.
int between(int a, int b, std::int64_t step, std::int64_t steps) {
  if (steps == 0) return a;
  const std::int64_t scaled = a * steps + (static_cast<std::int64_t>(b) - a) * step;
  return static_cast<int>(scaled >= 0 ? scaled / steps : -((-scaled + steps - 1) / steps));
}

}  // namespace

std::vector<PolygonRow> polygon_rows(std::span<const Vec2i> corners) {
  if (corners.empty()) return {};
  const auto by_y = [](const Vec2i& a, const Vec2i& b) { return a.y < b.y; };
  const auto [lowest, highest] = std::minmax_element(corners.begin(), corners.end(), by_y);
  std::vector<PolygonRow> rows(static_cast<std::size_t>(highest->y - lowest->y + 1));
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = {lowest->y + static_cast<int>(i), std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2i& from = corners[i];
    const Vec2i& to = corners[(i + 1) % corners.size()];
    const std::int64_t steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    for (std::int64_t step = 0; step <= steps; ++step) {
      PolygonRow& row = rows[static_cast<std::size_t>(between(from.y, to.y, step, steps) - lowest->y)];
      const int x = between(from.x, to.x, step, steps);
      row.left = std::min(row.left, x);
      row.right = std::max(row.right, x);
    }
  }
  return rows;
}

}  // namespace ps::raster
