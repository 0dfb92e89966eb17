// Worst pixels and the statistics of a rectangle, against naive forms of the same.
#include "image/pixel_ranking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "image/region_statistics.h"

namespace ps::pixel_ranking_test {
namespace {

TEST(PixelRanking, LargestFirstAndApart) {
  const unsigned seed = 31;
  std::mt19937 random(seed);
  for (int round = 0; round < 30; ++round) {
    Image<float> values(57, 43);
    for (float& value : values.pixels()) value = static_cast<float>(static_cast<int>(random() % 40) - 20);
    const RankingOptions options{25, static_cast<int>(random() % 6)};
    const auto ranked = rank_pixels(values, options);
    // The naive form: look for the largest again and again, and blot out its neighbourhood.
    Image<float> left = values;
    for (const RankedPixel& entry : ranked) {
      Vec2i best(-1, -1);
      for (int y = 0; y < left.height(); ++y)
        for (int x = 0; x < left.width(); ++x)
          if (left.at(x, y) > 0 && (best.x < 0 || left.at(x, y) > left.at(best.x, best.y))) best = {x, y};
      ASSERT_EQ(entry.pixel, best) << "seed " << seed;
      EXPECT_EQ(entry.value, static_cast<double>(values.at(best.x, best.y)));
      for (int y = 0; y < left.height(); ++y)
        for (int x = 0; x < left.width(); ++x)
          if (std::abs(x - best.x) <= options.apart && std::abs(y - best.y) <= options.apart) left.at(x, y) = 0;
    }
    EXPECT_EQ(ranked.size(), 25u);
  }
}

TEST(PixelRanking, NothingWhereNothingDiffers) {
  EXPECT_TRUE(rank_pixels(Image<float>(20, 20, 0)).empty());
  const Image<Rgb8> grey(20, 20, {9, 9, 9});
  EXPECT_TRUE(rank_pixels(level_differences(grey, grey)).empty());
  EXPECT_THROW(level_differences(grey, Image<Rgb8>(20, 21)), InputError);
}

TEST(PixelRanking, NotANumberIsWorstOfAll) {
  Image<float> values(8, 8, 0);
  values.at(2, 3) = 100;
  values.at(7, 7) = std::numeric_limits<float>::quiet_NaN();
  const auto ranked = rank_pixels(values, {10, 0});
  ASSERT_EQ(ranked.size(), 2u);
  EXPECT_EQ(ranked[0].pixel, Vec2i(7, 7));
  EXPECT_EQ(ranked[1].pixel, Vec2i(2, 3));
}

TEST(PixelRanking, DifferenceIsThatOfTheWorstChannel) {
  Image<Rgb8> a(3, 1, {10, 20, 30}), b = a;
  b.at(1, 0) = {12, 20, 25};
  b.at(2, 0) = {10, 255, 0};
  const Image<float> values = level_differences(a, b);
  EXPECT_EQ(values.at(0, 0), 0);
  EXPECT_EQ(values.at(1, 0), 5);
  EXPECT_EQ(values.at(2, 0), 235);
}

TEST(RegionStatistics, AgreesWithTheDefinition) {
  const unsigned seed = 7;
  std::mt19937 random(seed);
  Image<Rgb8> levels(31, 22);
  for (Rgb8& p : levels.pixels())
    p = {static_cast<std::uint8_t>(random() % 256), static_cast<std::uint8_t>(40 + random() % 3), 200};
  const TileRect rect{-5, 3, 17, 90};  // reaches beyond the picture
  const RegionStatistics s = region_statistics(levels, rect);
  ASSERT_EQ(s.pixels, 17u * 19u);
  double sum = 0;
  int low = 255, high = 0;
  for (int y = 3; y < 22; ++y)
    for (int x = 0; x < 17; ++x) {
      const int r = levels.at(x, y).r;
      sum += r;
      low = std::min(low, r);
      high = std::max(high, r);
    }
  const double mean = sum / 323;
  double squares = 0;
  for (int y = 3; y < 22; ++y)
    for (int x = 0; x < 17; ++x) squares += std::pow(levels.at(x, y).r - mean, 2);
  EXPECT_EQ(s.channels[0].lowest, low);
  EXPECT_EQ(s.channels[0].highest, high);
  EXPECT_NEAR(s.channels[0].mean, mean, 1e-9);
  EXPECT_NEAR(s.channels[0].deviation, std::sqrt(squares / 323), 1e-9) << "seed " << seed;
  EXPECT_EQ(s.channels[2].mean, 200);
  EXPECT_EQ(s.channels[2].deviation, 0);
  std::uint64_t counted = 0;
  for (const std::uint32_t n : s.channels[1].histogram) counted += n;
  EXPECT_EQ(counted, s.pixels);
  EXPECT_EQ(s.channels[1].histogram[43], 0u);
  EXPECT_EQ(region_statistics(levels, {40, 0, 50, 10}).pixels, 0u);
}

}  // namespace
}  // namespace ps::pixel_ranking_test
