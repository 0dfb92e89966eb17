// The map of a difference: what each way shows, its numbers, and the gain with which something is seen.
#include "image/difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "image/flip.h"
#include "image/heat_colour.h"

namespace ps::difference_test {
namespace {

constexpr Rgb8 of_a{0, 114, 178}, of_b{213, 94, 0};  // Okabe and Ito's blue and vermilion

Image<Rgb8> filled(Rgb8 colour, int width = 40, int height = 50) {
  Image<Rgb8> picture(width, height);
  std::fill(picture.pixels().begin(), picture.pixels().end(), colour);
  return picture;
}

TEST(DifferenceMap, ValuesOfEachWay) {
  const Image<Rgb8> a = filled({100, 50, 0}, 2, 1), b = filled({90, 80, 3}, 2, 1);
  EXPECT_EQ(difference_values(a, b, DifferenceMode::absolute).at(1, 0), 30);
  EXPECT_EQ(difference_values(a, b, DifferenceMode::sign).at(1, 0), 30);
  EXPECT_EQ(difference_values(b, a, DifferenceMode::sign).at(1, 0), -30);
  // 3 / (0 + 2.55) is more than 30 / (50 + 2.55).
  EXPECT_FLOAT_EQ(difference_values(a, b, DifferenceMode::relative).at(0, 0), static_cast<float>(3 / 2.55));
  EXPECT_FLOAT_EQ(difference_values(b, a, DifferenceMode::relative).at(0, 0), static_cast<float>(3 / 5.55));
  EXPECT_FLOAT_EQ(difference_values(a, b, DifferenceMode::flip).at(0, 0), static_cast<float>(flip_map(a, b).at(0, 0)));
  for (const auto mode :
       {DifferenceMode::absolute, DifferenceMode::sign, DifferenceMode::relative, DifferenceMode::flip})
    EXPECT_THROW(difference_values(a, filled({}, 1, 1), mode), InputError);
}

TEST(DifferenceMap, ColoursOfASignedMapAreThoseOfAAndB) {
  const DifferenceOptions options{2, DifferenceMode::sign};
  EXPECT_EQ(difference_colour(0, options), (Rgb8{0, 0, 0}));
  EXPECT_EQ(difference_colour(-255.0 / 4, options), of_a) << "half of what is white with this gain";
  EXPECT_EQ(difference_colour(255.0 / 4, options), of_b);
  for (const double value : {-127.5, 127.5, 200.0, -255.0})
    EXPECT_EQ(difference_colour(value, options), (Rgb8{255, 255, 255})) << value;
  EXPECT_EQ(difference_colour(0.25, {2, DifferenceMode::relative}), heat_colour(0.5));
  EXPECT_EQ(difference_colour(0.125, {4, DifferenceMode::flip}), heat_colour(0.5));
  EXPECT_EQ(difference_colour(30, {4, DifferenceMode::absolute}), (Rgb8{120, 120, 120}));
}

// 2000 pixels, of which 20 differ by 40 levels, one by 100 and one by 90: 99.9 % are at most 40 + something by rank.
TEST(DifferenceMap, NumbersAndTheGainThatShowsSomething) {
  const Image<Rgb8> a = filled({10, 10, 10});
  Image<Rgb8> b = a;
  for (int i = 0; i < 20; ++i) b.at(i, 7) = {10, 50, 10};
  b.at(3, 20) = {110, 10, 10};
  b.at(39, 49) = {10, 10, 100};
  const auto values = difference_values(a, b, DifferenceMode::sign);
  const DifferenceNumbers numbers = difference_numbers(values);
  EXPECT_EQ(numbers.largest, 100);
  EXPECT_EQ(numbers.at, (Vec2i{3, 20}));
  EXPECT_NEAR(numbers.mean, (20 * 40 + 100 + 90) / 2000.0, 1e-9);
  EXPECT_NEAR(numbers.differing, 22 / 2000.0, 1e-12);
  std::vector<float> sorted;
  for (const float v : values.pixels()) sorted.push_back(std::abs(v));
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(numbers.percentile, sorted[1997]) << "1998 of 2000 have at most this";
  EXPECT_EQ(numbers.percentile, 40);
  EXPECT_EQ(gain_that_shows(numbers, DifferenceMode::sign), 255.0 / 40);
  // In a rectangle only its pixels count.
  const DifferenceNumbers part = difference_numbers(values, TileRect{30, 40, 40, 50});
  EXPECT_EQ(part.at, (Vec2i{39, 49}));
  EXPECT_NEAR(part.differing, 0.01, 1e-12);
}

TEST(DifferenceMap, TheGainOfFewOfManyAndOfNoPixels) {
  const Image<Rgb8> a = filled({0, 0, 0});
  Image<Rgb8> one = a;
  one.at(5, 6) = {0, 51, 0};
  const auto gain = [&](const Image<Rgb8>& b, DifferenceMode mode) {
    return gain_that_shows(difference_numbers(difference_values(a, b, mode)), mode);
  };
  EXPECT_EQ(gain(one, DifferenceMode::absolute), 5) << "the percentile is 0, so the largest is white";
  EXPECT_EQ(gain(a, DifferenceMode::absolute), 1);
  EXPECT_EQ(gain(filled({255, 0, 0}), DifferenceMode::absolute), 1);
  EXPECT_EQ(gain(filled({255, 0, 0}), DifferenceMode::relative), 1) << "more than white is not made darker";
  Image<Rgb8> least = a;
  least.at(0, 0) = {0, 0, 1};
  EXPECT_EQ(gain(least, DifferenceMode::absolute), 255);
  EXPECT_LE(gain(least, DifferenceMode::flip), 256);
  EXPECT_EQ(difference_numbers(difference_values(a, a, DifferenceMode::sign)).at, (Vec2i{-1, -1}));
}

TEST(DifferenceMap, PicturesAreMadeOfTheColours) {
  const Image<Rgb8> a = filled({10, 200, 30}, 3, 2);
  Image<Rgb8> b = a;
  b.at(1, 1) = {60, 190, 30};
  for (const auto mode : {DifferenceMode::sign, DifferenceMode::relative, DifferenceMode::flip}) {
    const DifferenceOptions options{1.5, mode};
    const auto values = difference_values(a, b, mode);
    const auto picture = difference_picture(a, b, options);
    EXPECT_TRUE(picture == difference_picture(values, options));
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x) EXPECT_EQ(picture.at(x, y), difference_colour(values.at(x, y), options));
  }
  EXPECT_EQ(difference_picture(a, b, {.gain = 2}).at(1, 1), (Rgb8{100, 20, 0}));
}

}  // namespace
}  // namespace ps::difference_test
