#include "image/metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/difference.h"
#include "image/display.h"
#include "image/flip.h"
#include "image/ssim.h"

namespace metrics_test {
namespace {

using ps::Image;
using ps::Rgb8;
using ps::Vec3d;
using ps::Vec3f;

/// The two pictures of tests/unit/data/metrics_reference.py.
Image<Rgb8> picture(int which) {
  Image<Rgb8> image(24, 18);
  for (int y = 0; y < 18; ++y) {
    for (int x = 0; x < 24; ++x) {
      int r = (x * 10 + y * 3) % 256;
      int g = (x * y * 5 + 40) % 256;
      int b = (x / 4 + y / 3) % 2 != 0 ? 200 : 30;
      if (which == 1) {
        r = (r * 7 + x * x) / 8 % 256;
        if (x >= 8 && x < 13 && y >= 5 && y < 11) {
          g = 255 - g;
          b /= 2;
        }
      }
      image.at(x, y) = {static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g), static_cast<std::uint8_t>(b)};
    }
  }
  return image;
}

ps::ScalarImage plane_of(const Image<Rgb8>& image, std::uint8_t Rgb8::*channel) {
  ps::ScalarImage plane(image.width(), image.height());
  for (std::size_t i = 0; i < plane.pixels().size(); ++i) plane.pixels()[i] = image.pixels()[i].*channel;
  return plane;
}

Image<Vec3d> linear_light(const Image<Rgb8>& image) {
  const auto decode = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  Image<Vec3d> result(image.width(), image.height());
  for (std::size_t i = 0; i < result.pixels().size(); ++i) {
    const Rgb8 c = image.pixels()[i];
    result.pixels()[i] = {decode(c.r / 255.0), decode(c.g / 255.0), decode(c.b / 255.0)};
  }
  return result;
}

// The expected numbers are those that metrics_reference.py prints.
TEST(Metrics, SsimEqualsTheReference) {
  const auto a = picture(0), b = picture(1);
  constexpr double expected[] = {0.873323268586960, 0.553480509009129, 0.918714872393577};
  EXPECT_NEAR(ps::ssim(plane_of(a, &Rgb8::r), plane_of(b, &Rgb8::r), 255), expected[0], 1e-10);
  EXPECT_NEAR(ps::ssim(plane_of(a, &Rgb8::g), plane_of(b, &Rgb8::g), 255), expected[1], 1e-10);
  EXPECT_NEAR(ps::ssim(plane_of(a, &Rgb8::b), plane_of(b, &Rgb8::b), 255), expected[2], 1e-10);
  EXPECT_NEAR(ps::compare_images(a, b).ssim, (expected[0] + expected[1] + expected[2]) / 3, 1e-10);
}

TEST(Metrics, FlipEqualsTheReference) {
  const auto a = linear_light(picture(0)), b = linear_light(picture(1));
  const auto map = ps::flip_map(a, b);
  EXPECT_NEAR(map.at(0, 0), 0.002670444980802, 1e-10);
  EXPECT_NEAR(map.at(10, 7), 0.375746078126818, 1e-10);
  EXPECT_NEAR(ps::flip(a, b), 0.250429840069060, 1e-10);
  EXPECT_NEAR(ps::compare_images(picture(0), picture(1)).flip, 0.250429840069060, 1e-10);

  const auto near = ps::flip_map(a, b, {.pixels_per_degree = 20});
  EXPECT_NEAR(near.at(0, 0), 0.002503666656755, 1e-10);
  EXPECT_NEAR(near.at(10, 7), 0.426549231120813, 1e-10);
  EXPECT_NEAR(ps::flip(a, b, {.pixels_per_degree = 20}), 0.258548262098822, 1e-10);
}

/// The first picture with a fault at each pixel; metrics_reference.py has the same.
template <class Fault>
Image<Rgb8> changed(Fault&& fault) {
  const Image<Rgb8> before = picture(0);
  Image<Rgb8> after = before;
  for (int y = 0; y < 18; ++y)
    for (int x = 0; x < 24; ++x) after.at(x, y) = fault(before, x, y);
  return after;
}

TEST(Metrics, FlipEqualsTheReferenceForEachKindOfFault) {
  const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
  const auto brighter = changed([&](const Image<Rgb8>& p, int x, int y) {
    const Rgb8 c = p.at(x, y);
    return Rgb8{byte(std::min(c.r + 5, 255)), byte(std::min(c.g + 5, 255)), byte(std::min(c.b + 5, 255))};
  });
  const auto shifted = changed([](const Image<Rgb8>& p, int x, int y) { return p.at(std::max(x - 1, 0), y); });
  const auto square = changed([](const Image<Rgb8>& p, int x, int y) {
    return x >= 9 && x < 15 && y >= 6 && y < 12 ? Rgb8{0, 0, 0} : p.at(x, y);
  });
  const auto dithered = changed([&](const Image<Rgb8>& p, int x, int y) {
    const Rgb8 c = p.at(x, y);
    return Rgb8{c.r, c.g, byte((c.b + ((x + y) % 2 != 0 ? 16 : 240)) % 256)};
  });
  const auto first = picture(0);
  EXPECT_NEAR(ps::flip(first, brighter), 0.113125026731452, 1e-10);
  EXPECT_NEAR(ps::flip(first, shifted), 0.291544412210807, 1e-10);
  EXPECT_NEAR(ps::flip(first, square), 0.127920711084671, 1e-10);
  EXPECT_NEAR(ps::flip(first, dithered), 0.035087025481328, 1e-10);
}

TEST(Metrics, SumsFollowTheirFormulas) {
  Image<Rgb8> a(4, 5, {10, 20, 30});
  Image<Rgb8> b = a;
  b.at(1, 2) = {13, 16, 30};  // errors 3 and 4, of 60 values
  const auto result = ps::compare_images(a, b);
  EXPECT_FALSE(result.identical);
  EXPECT_EQ(result.differing, 1);
  EXPECT_EQ(result.max, 4);
  EXPECT_NEAR(result.mae, 7.0 / 60, 1e-15);
  EXPECT_NEAR(result.rmse, std::sqrt(25.0 / 60), 1e-15);
  ASSERT_TRUE(result.psnr);
  EXPECT_NEAR(*result.psnr, 20 * std::log10(255 / std::sqrt(25.0 / 60)), 1e-12);
  EXPECT_LT(result.ssim, 1);
  EXPECT_GT(result.flip, 0);

  const auto equal = ps::compare_images(a, a);
  EXPECT_TRUE(equal.identical);
  EXPECT_FALSE(equal.psnr);
  EXPECT_EQ(equal.mae, 0);
  EXPECT_EQ(equal.ssim, 1);
  EXPECT_EQ(equal.flip, 0);
  EXPECT_THROW(ps::compare_images(a, Image<Rgb8>(5, 4)), ps::InputError);
}

TEST(Metrics, ChannelsAloneGiveTheSameSums) {
  Image<Rgb8> a(4, 5, {10, 20, 30});
  Image<Rgb8> b = a;
  b.at(1, 2) = {13, 16, 30};
  b.at(3, 4) = {10, 255, 31};
  const auto all = ps::compare_images(a, b), sums = ps::compare_channels(a, b);
  EXPECT_EQ(sums.differing, 2);
  EXPECT_FALSE(sums.identical);
  EXPECT_EQ(sums.mae, all.mae);
  EXPECT_EQ(sums.rmse, all.rmse);
  EXPECT_EQ(sums.psnr, all.psnr);
  EXPECT_EQ(sums.max, 235);
  EXPECT_TRUE(ps::compare_channels(a, a).identical);
  EXPECT_THROW(ps::compare_channels(a, Image<Rgb8>(5, 4)), ps::InputError);

  Image<ps::Vec3d> c(2, 1, ps::Vec3d(1)), d = c;
  d.at(1, 0).b += 0x1p-40;  // too little for a float
  EXPECT_EQ(ps::compare_channels(c, d).differing, 1);
  EXPECT_EQ(ps::compare_channels(c, d).max, 0x1p-40);
  EXPECT_EQ(ps::compare_channels(c, d).mae, 0x1p-40 / 6);
}

// Traps of mean metrics, with the values found by other programs.
TEST(Metrics, KnowsItsKnownBlindSpots) {
  const auto flat = [](int level) {
    const auto byte = static_cast<std::uint8_t>(level);
    return Image<Rgb8>(64, 64, {byte, byte, byte});
  };
  EXPECT_NEAR(ps::compare_images(flat(0), flat(2)).ssim, 0.619, 5e-4);
  EXPECT_NEAR(ps::compare_images(flat(255), flat(253)).ssim, 1, 5e-5);

  Image<Rgb8> checker(64, 64), inverse(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const auto level = static_cast<std::uint8_t>((x + y) % 2 * 255);
      const auto other = static_cast<std::uint8_t>(255 - level);
      checker.at(x, y) = {level, level, level};
      inverse.at(x, y) = {other, other, other};
    }
  }
  const auto result = ps::compare_images(checker, inverse);
  EXPECT_EQ(result.rmse, 255);
  EXPECT_NEAR(result.ssim, -0.996, 1e-3);
  EXPECT_LT(result.flip, 0.01) << "the eye does not see single pixels at this distance";

  // Black against white: HyAB is 100, which lies on the upper, flat part of the redistribution.
  const double largest = 41.276;  // the power 0.7 of green against blue, as the method's authors give it
  const double expected = 0.95 + (std::pow(100, 0.7) - 0.4 * largest) / (0.6 * largest) * 0.05;
  EXPECT_NEAR(ps::compare_images(flat(0), flat(255)).flip, expected, 1e-5);
}

TEST(Metrics, FloatsAreComparedAsTheyAre) {
  Image<Vec3f> a(3, 3, Vec3f(0.5f));
  Image<Vec3f> b = a;
  b.at(0, 0) = Vec3f(0.75f, 0.5f, 0.5f);
  auto result = ps::compare_linear(a, b);
  EXPECT_EQ(result.differing, 1);
  EXPECT_EQ(result.max, 0.25);
  EXPECT_NEAR(result.rmse, 0.25 / std::sqrt(27.0), 1e-15);
  EXPECT_NEAR(*result.psnr, -20 * std::log10(0.25 / std::sqrt(27.0)), 1e-12);

  const float nan = std::numeric_limits<float>::quiet_NaN();
  a.at(2, 2) = b.at(2, 2) = Vec3f(nan);
  b.at(1, 1).g = std::numeric_limits<float>::infinity();
  result = ps::compare_linear(a, b);
  EXPECT_EQ(result.not_finite, 2);
  EXPECT_EQ(result.differing, 2);
  EXPECT_EQ(result.max, 0.25);
  EXPECT_TRUE(std::isfinite(result.rmse) && std::isfinite(result.ssim) && std::isfinite(result.flip));
  EXPECT_TRUE(ps::compare_linear(a, a).identical);
}

TEST(Difference, ShowsHowFarPixelsAreApart) {
  const Rgb8 a{100, 200, 50}, b{110, 190, 50};
  EXPECT_EQ(ps::difference_pixel(a, b, 1), (Rgb8{10, 10, 0}));
  EXPECT_EQ(ps::difference_pixel(a, b, 8), (Rgb8{80, 80, 0}));
  EXPECT_EQ(ps::difference_pixel(a, b, 100), (Rgb8{255, 255, 0}));
  const auto picture_a = picture(0), picture_b = picture(1);
  const auto difference = ps::difference_picture(picture_a, picture_b, {.gain = 4});
  for (int y = 0; y < 18; ++y)
    for (int x = 0; x < 24; ++x)
      EXPECT_EQ(difference.at(x, y), ps::difference_pixel(picture_a.at(x, y), picture_b.at(x, y), 4));
  EXPECT_THROW(ps::difference_picture(picture_a, Image<Rgb8>(1, 1)), ps::InputError);
}

}  // namespace
}  // namespace metrics_test
