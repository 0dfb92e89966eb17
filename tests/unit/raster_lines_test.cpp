#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "raster/clear/lines/walk_line.h"

namespace ps::raster {
namespace raster_lines_test {
namespace {

std::vector<Vec2i> walk(LineAlgorithm algorithm, Vec2d from, Vec2d to,
                        SamplePosition position = SamplePosition::centre) {
  std::vector<Vec2i> pixels;
  walk_line(algorithm, from, to, position, [&](const Vec2i& pixel, int step) {
    EXPECT_EQ(step, static_cast<int>(pixels.size()));
    pixels.push_back(pixel);
  });
  return pixels;
}

TEST(Lines, YOfXLeavesGapsInSteepLinesAndXOfYInFlatOnes) {
  // CGFS ch. 6: (-50, -200)-(60, 240) has 111 columns and 441 rows.
  EXPECT_EQ(walk(LineAlgorithm::y_of_x, {-50, -200}, {60, 240}).size(), 111u);
  EXPECT_EQ(walk(LineAlgorithm::x_of_y, {-50, -200}, {60, 240}).size(), 441u);
  EXPECT_EQ(walk(LineAlgorithm::y_of_x, {-200, -100}, {240, 120}).size(), 441u);
  EXPECT_EQ(walk(LineAlgorithm::x_of_y, {-200, -100}, {240, 120}).size(), 221u);
  for (const auto algorithm : {LineAlgorithm::general, LineAlgorithm::interpolate, LineAlgorithm::bresenham}) {
    EXPECT_EQ(walk(algorithm, {-50, -200}, {60, 240}).size(), 441u);
    EXPECT_EQ(walk(algorithm, {-200, -100}, {240, 120}).size(), 441u);
  }
}

TEST(Lines, EveryAlgorithmDrawsAPointAsOnePixel) {
  for (const auto algorithm : {LineAlgorithm::general, LineAlgorithm::y_of_x, LineAlgorithm::x_of_y,
                               LineAlgorithm::interpolate, LineAlgorithm::bresenham}) {
    const auto pixels = walk(algorithm, {12.25, -7.75}, {12.25, -7.75});
    ASSERT_EQ(pixels.size(), 1u);
    EXPECT_EQ(pixels[0], Vec2i(12, -8));
    EXPECT_EQ(walk(algorithm, {12.25, -7.75}, {12.25, -7.75}, SamplePosition::corner)[0], Vec2i(12, -7));
  }
}

class LineProperty : public testing::Test {
 protected:
  std::mt19937 random{20240611};
  Vec2d whole_point(int reach) {
    std::uniform_int_distribution<int> range(-reach, reach);
    return {range(random), range(random)};
  }
};

TEST_F(LineProperty, BresenhamStaysWithinHalfAPixelAndIsConnected) {
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec2d a = whole_point(300), b = whole_point(300);
    const auto pixels = walk(LineAlgorithm::bresenham, a, b);
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double longer = std::max(std::abs(dx), std::abs(dy));
    ASSERT_EQ(pixels.size(), static_cast<std::size_t>(longer) + 1) << "seed 20240611, trial " << trial;
    EXPECT_EQ(pixels.front(), Vec2i(a));
    EXPECT_EQ(pixels.back(), Vec2i(b));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const double t = longer > 0 ? static_cast<double>(i) / longer : 0;
      // Exact in one coordinate, at most half a pixel off in the other.
      ASSERT_LE(std::abs(pixels[i].x - (a.x + dx * t)), 0.5 + 1e-9) << "trial " << trial;
      ASSERT_LE(std::abs(pixels[i].y - (a.y + dy * t)), 0.5 + 1e-9) << "trial " << trial;
    }
  }
}

TEST_F(LineProperty, GeneralEqualsTheClosedFormInDoubleAndBresenhamNearby) {
  for (int trial = 0; trial < 500; ++trial) {
    Vec2d a = whole_point(250), b = whole_point(250);
    const auto pixels = walk(LineAlgorithm::general, a, b);
    const int along = std::abs(b.x - a.x) > std::abs(b.y - a.y) ? 0 : 1;
    const int across = 1 - along;
    if (b[along] < a[along]) std::swap(a, b);
    const auto length = static_cast<std::int64_t>(b[along] - a[along]);
    ASSERT_EQ(pixels.size(), static_cast<std::size_t>(length) + 1);
    std::set<std::pair<int, int>> stepped;
    for (const Vec2i& p : walk(LineAlgorithm::bresenham, a, b)) stepped.insert({p.x, p.y});
    for (std::int64_t i = 0; i <= length; ++i) {
      const Vec2i pixel = pixels[static_cast<std::size_t>(i)];
      EXPECT_EQ(pixel[along], static_cast<int>(a[along]) + static_cast<int>(i));
      // floor(a + i * rise / length) in whole numbers; where the line runs exactly through a border of pixels, the
      // rounding of repeated additions decides.
      const auto rise = static_cast<std::int64_t>(b[across] - a[across]);
      const std::int64_t numerator = rise * i;
      const bool tie = length == 0 || numerator % length == 0;
      if (!tie) {
        const auto exact =
            static_cast<int>(std::floor(a[across] + static_cast<double>(numerator) / static_cast<double>(length)));
        EXPECT_EQ(pixel[across], exact) << "seed 20240611, trial " << trial << ", step " << i;
      }
      Vec2i upper = pixel;
      upper[across] += 1;
      Vec2i lower = pixel;
      lower[across] -= 1;
      const bool near =
          stepped.count({pixel.x, pixel.y}) || stepped.count({upper.x, upper.y}) || stepped.count({lower.x, lower.y});
      EXPECT_TRUE(near) << "trial " << trial;
    }
  }
}

TEST(Interpolate, RepeatedAdditionDriftsAsMeasured) {
  // stability.md row 24: 600 steps in float end 0.018 off at most, 1e5 steps up to 3.0; double stays exact enough.
  double worst = 0;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> range(0, 600);
  for (int trial = 0; trial < 500; ++trial) {
    const auto d0 = static_cast<float>(range(random)), d1 = static_cast<float>(range(random));
    InterpolatedValues<float> values(0, d0, 600, d1);
    worst = std::max(worst, static_cast<double>(std::abs(values.at(600) - d1)));
    InterpolatedValues<double> exact(0, d0, 600, d1);
    EXPECT_NEAR(exact.at(600), d1, 1e-10);
  }
  EXPECT_GT(worst, 0.001) << "seed 7";
  EXPECT_LT(worst, 0.03) << "seed 7";
}

}  // namespace
}  // namespace raster_lines_test
}  // namespace ps::raster
