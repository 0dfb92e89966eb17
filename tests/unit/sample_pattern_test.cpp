// Patterns against what their definitions promise, and against the expected discrepancy of random points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "raytrace/sampling/pattern.h"

namespace ps::sample_pattern_test {
namespace {

std::vector<Vec2d> points(SamplePattern pattern, int count, Vec2i pixel) {
  std::vector<Vec2d> list;
  for (int i = 0; i < count; ++i) list.push_back(sample_in_square(pattern, i, count, pixel));
  return list;
}

/// Squared L2 star discrepancy (Warnock 1972).
double discrepancy(const std::vector<Vec2d>& list) {
  const double n = static_cast<double>(list.size());
  double one = 0, two = 0;
  for (const Vec2d& p : list) {
    one += (1 - p.x * p.x) * (1 - p.y * p.y);
    for (const Vec2d& q : list) two += (1 - std::max(p.x, q.x)) * (1 - std::max(p.y, q.y));
  }
  return 1.0 / 9 - one / (2 * n) + two / (n * n);
}

double mean_discrepancy(SamplePattern pattern, int count) {
  constexpr int side = 20;
  double sum = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) sum += discrepancy(points(pattern, count, {x, y}));
  return sum / (side * side);
}

constexpr SamplePattern patterns[] = {SamplePattern::grid, SamplePattern::jitter, SamplePattern::random,
                                      SamplePattern::halton, SamplePattern::r2};

TEST(SamplePattern, OneSampleOfTheGridIsTheMiddle) {
  EXPECT_EQ(sample_in_square(SamplePattern::grid, 0, 1, {3, 4}), Vec2d(0.5, 0.5));
  EXPECT_EQ(sample_in_pixel(SamplePattern::grid, 0, 1, {3, 4}, {0, 1}), Vec2d(0, 1));
}

TEST(SamplePattern, SquareNumbersMakeSquareGrids) {
  for (const int side : {2, 3, 4, 8, 64})
    for (int i = 0; i < side * side; ++i) {
      const int column = i % side, row = i / side;
      const Vec2d expected{(column + 0.5) / side, (row + 0.5) / side};
      const Vec2d got = sample_in_square(SamplePattern::grid, i, side * side, {7, 9});
      ASSERT_NEAR(got.x, expected.x, 1e-15);
      ASSERT_NEAR(got.y, expected.y, 1e-15);
    }
}

// Any number of samples: every pattern stays in the square; a grid's centre of mass is the middle, its cells do not
// overlap.
TEST(SamplePattern, AnyNumberFillsTheSquare) {
  for (int count = 1; count <= 70; ++count) {
    Vec2d sum{0, 0};
    for (const SamplePattern pattern : patterns)
      for (const Vec2d& p : points(pattern, count, {11, 5})) {
        ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << count;
        if (pattern == SamplePattern::grid) sum += p;
      }
    EXPECT_NEAR(sum.x / count, 0.5, 1e-12) << count;
    EXPECT_NEAR(sum.y / count, 0.5, 1e-12) << count;
  }
}

TEST(SamplePattern, JitterKeepsToItsCell) {
  for (int y = 0; y < 8; ++y)
    for (int i = 0; i < 16; ++i) {
      const Vec2d p = sample_in_square(SamplePattern::jitter, i, 16, {y, 3});
      EXPECT_EQ(static_cast<int>(p.x * 4), i % 4);
      EXPECT_EQ(static_cast<int>(p.y * 4), i / 4);
    }
}

TEST(SamplePattern, PixelsHaveNumbersOfTheirOwn) {
  for (const SamplePattern pattern :
       {SamplePattern::jitter, SamplePattern::random, SamplePattern::halton, SamplePattern::r2}) {
    EXPECT_NE(points(pattern, 4, {1, 2}), points(pattern, 4, {2, 1}));
    EXPECT_EQ(points(pattern, 4, {1, 2}), points(pattern, 4, {1, 2}));
  }
}

// The expected squared discrepancy of n independent points is (2^-d - 3^-d) / n. A jittered grid beats it, falling with
// n^-1.5; sequences made for evenness fall faster still, so that they have overtaken the grid at 256 samples.
TEST(SamplePattern, EvennessComesInTheKnownOrder) {
  for (const int count : {16, 64}) {
    const double random = mean_discrepancy(SamplePattern::random, count);
    EXPECT_NEAR(random * count, 0.25 - 1.0 / 9, 0.02) << count;
    for (const SamplePattern even : {SamplePattern::jitter, SamplePattern::halton, SamplePattern::r2})
      EXPECT_LT(mean_discrepancy(even, count), random / 2) << count;
  }
  const double jitter = mean_discrepancy(SamplePattern::jitter, 256);
  EXPECT_NEAR(mean_discrepancy(SamplePattern::jitter, 64) / jitter, 8, 2);  // 4^1.5
  EXPECT_LT(mean_discrepancy(SamplePattern::halton, 256), jitter);
  EXPECT_LT(mean_discrepancy(SamplePattern::r2, 256), jitter);
}

}  // namespace
}  // namespace ps::sample_pattern_test
