#include "raster/clear/polygon_rows.h"

#include <algorithm>
#include <array>
#include <random>

#include <gtest/gtest.h>

#include "support/environment.h"

namespace ps::raster {
namespace polygon_rows_test {
namespace {

/// y, left and right of each row.
std::vector<std::array<int, 3>> spans(std::span<const Vec2i> vertices, RowRange range = {}) {
  std::vector<std::array<int, 3>> all;
  for (const PolygonRow& row : polygon_rows(vertices, range)) all.push_back({row.y, row.left.x, row.right.x});
  return all;
}

TEST(PolygonRows, AreThosePrintedInTheLab) {
  const std::array<Vec2i, 3> vertices{Vec2i{10, 5}, {5, 10}, {15, 15}};
  const std::vector<std::array<int, 3>> printed{{5, 10, 10},  {6, 9, 10},   {7, 8, 11},  {8, 7, 11},
                                                {9, 6, 12},   {10, 5, 12},  {11, 7, 13}, {12, 9, 13},
                                                {13, 11, 14}, {14, 13, 14}, {15, 15, 15}};
  EXPECT_EQ(spans(vertices), printed);
}

TEST(PolygonRows, CountAsManyRowsAsTheLabSays) {
  const std::array<Vec2i, 3> vertices{Vec2i{10, 20}, {30, 10}, {20, 40}};
  EXPECT_EQ(polygon_rows(vertices).size(), 31u);
  EXPECT_TRUE(polygon_rows({}).empty());
}

/// The lab's own loops: every step of every edge, in exact arithmetic.
std::vector<PolygonRow> step_by_step(const std::vector<Vec2i>& vertices) {
  int low = vertices.front().y, high = low;
  for (const Vec2i& v : vertices) low = std::min(low, v.y), high = std::max(high, v.y);
  std::vector<PolygonRow> rows(static_cast<std::size_t>(high - low + 1));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].y = low + static_cast<int>(i);
    rows[i].left.x = std::numeric_limits<int>::max();
    rows[i].right.x = std::numeric_limits<int>::min();
  }
  const auto down = [](long a, long b) { return a / b - (a % b < 0 ? 1 : 0); };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2i a = vertices[i], b = vertices[(i + 1) % vertices.size()];
    const long steps = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
    for (long s = 0; s <= steps; ++s) {
      const long divisor = std::max(steps, 1L);
      const int x = a.x + static_cast<int>(down((b.x - a.x) * s, divisor));
      const int y = a.y + static_cast<int>(down((b.y - a.y) * s, divisor));
      PolygonRow& row = rows[static_cast<std::size_t>(y - low)];
      const PolygonRowEnd end{x, static_cast<int>(i), s, steps};
      if (x < row.left.x) row.left = end;
      if (x > row.right.x) row.right = end;
    }
  }
  return rows;
}

TEST(PolygonRows, AreTheLabsWalkWithoutItsSteps) {
  const std::uint64_t seed = test::test_seed();
  SCOPED_TRACE("PIXELSCOPE_TEST_SEED=" + std::to_string(seed));
  std::mt19937_64 random(seed);
  const auto pick = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  for (int trial = 0; trial < 4000; ++trial) {
    std::vector<Vec2i> vertices;
    const int reach = trial % 3 == 0 ? 4 : 40;
    for (int i = pick(1, 6); i > 0; --i) vertices.push_back({pick(-reach, reach), pick(-reach, reach)});
    const auto expected = step_by_step(vertices);
    ASSERT_EQ(polygon_rows(vertices), expected) << "trial " << trial;
    // Some rows are those of all.
    const int first = pick(-reach, reach), last = pick(-reach, reach);
    std::vector<PolygonRow> some;
    for (const PolygonRow& row : expected)
      if (row.y >= first && row.y <= last) some.push_back(row);
    ASSERT_EQ(polygon_rows(vertices, {first, last}), some) << "trial " << trial;
  }
}

// A walk of a hundred million steps, of which only the first and the last in each row matter.
TEST(PolygonRows, LongEdgesCostRowsAndNotSteps) {
  constexpr int far = 1 << 29;
  const std::array<Vec2i, 3> vertices{Vec2i{-far, 0}, {far, 3}, {0, -2}};
  const auto rows = polygon_rows(vertices);
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[2].left.x, -far);
  EXPECT_EQ(rows[5].right.x, far);
}

}  // namespace
}  // namespace polygon_rows_test
}  // namespace ps::raster
