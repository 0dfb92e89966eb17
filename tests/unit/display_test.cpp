#include "image/display.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "frame/display_frame.h"
#include "image/mixing.h"
#include "support/seeded_random.h"

namespace display_test {
namespace {

using ps::ColourDepth;
using ps::DisplayTransform;
using ps::Rgb8;
using ps::Vec3d;
using ps::Vec3f;

int level(double linear, const DisplayTransform& transform = {}) {
  return ps::display_pixel(Vec3d(linear), transform).r;
}

TEST(Display, RoundsHalvesToEven) {
  EXPECT_EQ(level(25.5 / 255), 26);
  EXPECT_EQ(level(76.5 / 255), 76);
  for (int i = 0; i < 255; ++i) {
    const double tie = (i + 0.5) / 255;
    if (tie * 255 != i + 0.5) continue;  // the division rounded: no longer a tie
    EXPECT_EQ(level(tie), i % 2 == 0 ? i : i + 1) << "between " << i << " and " << i + 1;
  }
  // Next to a tie the nearer level wins.
  EXPECT_EQ(level(std::nextafter(25.5 / 255, 0.0)), 25);
  EXPECT_EQ(level(std::nextafter(76.5 / 255, 1.0)), 77);
}

TEST(Display, ClampsAndStoresNanAsZero) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double gamma : {1.0, 2.2}) {
    for (const auto depth : {ColourDepth::bits24, ColourDepth::bits16, ColourDepth::bits15}) {
      const DisplayTransform transform{.gamma = gamma, .depth = depth};
      EXPECT_EQ(level(-1, transform), 0);
      EXPECT_EQ(level(-infinity, transform), 0);
      EXPECT_EQ(level(nan, transform), 0);
      EXPECT_EQ(level(0, transform), 0);
      EXPECT_EQ(level(1, transform), 255);
      EXPECT_EQ(level(1e300, transform), 255);
      EXPECT_EQ(level(infinity, transform), 255);
    }
  }
}

TEST(Display, CountsNanPixels) {
  ps::Image<Vec3f> image(3, 2, Vec3f(0.5f));
  EXPECT_EQ(ps::count_nan_pixels(image), 0u);
  image.at(0, 0).g = std::numeric_limits<float>::quiet_NaN();
  image.at(2, 1) = Vec3f(std::numeric_limits<float>::quiet_NaN());
  image.at(1, 1).b = std::numeric_limits<float>::infinity();
  EXPECT_EQ(ps::count_nan_pixels(image), 2u);
}

TEST(Display, AppliesExposureThenGamma) {
  EXPECT_EQ(level(0.25, {.exposure = 2}), 128);  // 127.5, to even
  EXPECT_EQ(level(0.5, {.gamma = 2.2}), 186);    // 255 * 0.5^(1/2.2) = 186.08
  EXPECT_EQ(level(0.05, {.exposure = 10, .gamma = 2.2}), 186);
  EXPECT_EQ(level(0.5, {.exposure = 4, .gamma = 0.5}), 255);  // clamped before the curve
}

TEST(Display, FewBitsShowBands) {
  std::set<int> reds16, greens16, reds15, greens15;
  for (int i = 0; i <= 10000; ++i) {
    const Vec3d grey(i / 10000.0);
    const Rgb8 p16 = ps::display_pixel(grey, {.depth = ColourDepth::bits16});
    const Rgb8 p15 = ps::display_pixel(grey, {.depth = ColourDepth::bits15});
    reds16.insert(p16.r);
    greens16.insert(p16.g);
    reds15.insert(p15.r);
    greens15.insert(p15.g);
    EXPECT_EQ(p16.r, p16.b);
    EXPECT_LE(std::abs(p16.r - i * 255 / 10000.0), 255.0 / 62 + 0.5 + 1e-9);
    EXPECT_LE(std::abs(p16.g - i * 255 / 10000.0), 255.0 / 126 + 0.5 + 1e-9);
  }
  EXPECT_EQ(reds16.size(), 32u);
  EXPECT_EQ(greens16.size(), 64u);
  EXPECT_EQ(reds15.size(), 32u);
  EXPECT_EQ(greens15.size(), 32u);
  for (unsigned q = 0; q < 32; ++q)
    EXPECT_TRUE(reds16.count(static_cast<int>(std::lround(q * 255.0 / 31)))) << "level of " << q << " of 31";
}

// The picture's path through whole rows against the rounding of the C library.
TEST(Display, PicturesAgreeWithSinglePixels) {
  ps::test::SeededRandom random;
  std::uniform_int_distribution<int> halves(0, 510);
  ps::Image<Vec3d> exact(37, 23);
  for (Vec3d& pixel : exact.pixels())
    pixel = {random.between(-0.2, 1.4), halves(random) / 510.0, random.between(-0.2, 1.4)};
  ps::Image<Vec3f> rounded(37, 23);
  for (std::size_t i = 0; i < exact.pixels().size(); ++i) rounded.pixels()[i] = Vec3f(exact.pixels()[i]);

  ASSERT_EQ(std::fegetround(), FE_TONEAREST);
  const auto expected = [](double value) {
    return static_cast<int>(std::nearbyint(std::min(std::max(value, 0.0), 1.0) * 255));
  };
  const auto shown = ps::display_image(exact);
  for (std::size_t i = 0; i < exact.pixels().size(); ++i) {
    ASSERT_EQ(shown.pixels()[i].r, expected(exact.pixels()[i].r));
    ASSERT_EQ(shown.pixels()[i].g, expected(exact.pixels()[i].g));
  }
  for (const double exposure : {1.0, 1.7}) {
    for (const double gamma : {1.0, 2.2}) {
      for (const auto depth : {ColourDepth::bits24, ColourDepth::bits16, ColourDepth::bits15}) {
        const DisplayTransform transform{exposure, gamma, depth};
        const auto a = ps::display_image(exact, transform);
        const auto b = ps::display_image(rounded, transform);
        for (std::size_t i = 0; i < a.pixels().size(); ++i) {
          ASSERT_EQ(a.pixels()[i], ps::display_pixel(exact.pixels()[i], transform));
          ASSERT_EQ(b.pixels()[i], ps::display_pixel(Vec3d(rounded.pixels()[i]), transform));
        }
      }
    }
  }
}

// The curve is looked up, not computed for each pixel; the formula itself is the C library's.
TEST(Display, CurveFollowsItsFormula) {
  for (const double gamma : {0.1, 0.45, 1.8, 2.2, 5.0}) {
    for (const auto& [depth, highest] : {std::pair{ColourDepth::bits24, 255}, {ColourDepth::bits15, 31}}) {
      for (int i = 0; i <= 3000; ++i) {
        const double linear = std::pow(i / 3000.0, 3);
        const double exact = std::pow(linear, 1 / gamma) * highest;
        if (std::abs(exact - std::floor(exact) - 0.5) < 1e-9) continue;
        const int expected = static_cast<int>(std::lround(std::nearbyint(exact) * 255 / highest));
        ASSERT_EQ(level(linear, {.gamma = gamma, .depth = depth}), expected) << "gamma " << gamma << " of " << linear;
      }
    }
  }
}

TEST(Display, LevelsSurviveTheWayToFloatAndBack) {
  ps::Image<Rgb8> levels(256, 1);
  for (int i = 0; i < 256; ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    levels.at(i, 0) = {byte, static_cast<std::uint8_t>(255 - i), byte};
  }
  EXPECT_EQ(ps::display_image(ps::to_unit(levels)), levels);
}

TEST(DisplayFrame, PrefersDoublesAndTilesMakeTheWhole) {
  ps::Frame frame;
  frame.colour = ps::Image<Vec3f>(10, 7);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 10; ++x)
      frame.colour.at(x, y) = Vec3f(0.01f * static_cast<float>(x), 0.1f * static_cast<float>(y), 0.3f);
  const ps::Settings settings;
  const auto whole = ps::display_frame(frame, settings);
  ps::Image<Rgb8> target(10, 7);
  for (const auto& tile : ps::make_tiles(10, 7, 4)) ps::display_tile(frame, settings, tile, target);
  EXPECT_EQ(target, whole);
  EXPECT_EQ(whole.at(9, 6), ps::display_at(frame, settings, {9, 6}));

  // 25.5 levels exactly in double; the float nearest to it lies above or below the tie.
  frame.colour_double = ps::Image<Vec3d>(10, 7, Vec3d(76.5 / 255));
  frame.colour.at(3, 3) = Vec3f(0.9f);
  EXPECT_EQ(ps::display_frame(frame, settings).at(3, 3), (Rgb8{76, 76, 76}));
  EXPECT_EQ(ps::display_at(frame, settings, {3, 3}), (Rgb8{76, 76, 76}));
}

TEST(Mixing, PrimariesMakeTheBooksColours) {
  const Vec3d red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), yellow(1, 1, 0), cyan(0, 1, 1), magenta(1, 0, 1);
  EXPECT_EQ(ps::mix_additive(red, green), yellow);
  EXPECT_EQ(ps::mix_additive(ps::mix_additive(red, green), blue), Vec3d(1, 1, 1));
  EXPECT_EQ(ps::mix_subtractive(yellow, cyan), green);
  EXPECT_EQ(ps::mix_subtractive(yellow, magenta), red);
  EXPECT_EQ(ps::mix_subtractive(ps::mix_subtractive(yellow, cyan), magenta), Vec3d(0, 0, 0));
  EXPECT_EQ(ps::clamp_colour(Vec3d(1.5, -0.5, 0.25)), Vec3d(1, 0, 0.25));
  EXPECT_EQ(ps::clamp_colour(Vec3d(std::numeric_limits<double>::quiet_NaN())), Vec3d(0, 0, 0));
}

}  // namespace
}  // namespace display_test
