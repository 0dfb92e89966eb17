// portable:: against the C library in a wider type: the error in units of the last place, exact cases, and the bits
// themselves, which must be the same on every processor.
#include "math/portable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace ps::portable_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr unsigned seed = 1;

/// Distance in units in the last place of `truth` rounded to double.
double ulps(double found, long double truth) {
  const double rounded = static_cast<double>(truth);
  if (found == rounded) return 0;
  const double unit = std::nextafter(std::abs(rounded), infinity) - std::abs(rounded);
  return static_cast<double>(std::abs(static_cast<long double>(found) - truth) / static_cast<long double>(unit));
}

/// Calls probe() with angles: within a few turns, up to 2^20, and next to multiples of pi / 2.
template <class Probe>
void for_angles(Probe&& probe) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> signed_unit(-1, 1);
  std::uniform_int_distribution<int> quarters(-600000, 600000);
  for (int i = 0; i < 100000; ++i) {
    probe(7 * signed_unit(random));
    probe(signed_unit(random) * 0x1p20);
    probe(quarters(random) * 1.5707963267948966);
    probe(std::ldexp(signed_unit(random), -std::abs(quarters(random)) / 20000));
  }
}

/// Calls probe() with numbers from -1 to 1, many of them next to -1, 0 and 1.
template <class Probe>
void for_ratios(Probe&& probe) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> signed_unit(-1, 1);
  std::uniform_int_distribution<int> exponents(-52, 0);
  for (int i = 0; i < 100000; ++i) {
    const double small = std::ldexp(signed_unit(random), exponents(random));
    probe(signed_unit(random));
    probe(small);
    probe(small < 0 ? -1 - small : 1 - small);
  }
}

TEST(Portable, SineAndCosineAreWithinOneAndAHalfUlp) {
  RecordProperty("seed", seed);
  double sine = 0, cosine = 0, tangent = 0, naive = 0;
  for_angles([&](double angle) {
    const auto exact = static_cast<long double>(angle);
    sine = std::max(sine, ulps(portable::sin(angle), std::sin(exact)));
    cosine = std::max(cosine, ulps(portable::cos(angle), std::cos(exact)));
    tangent = std::max(tangent, ulps(portable::tan(angle), std::tan(exact)));
    constexpr double turn = 6.283185307179586;
    naive = std::max(naive, ulps(portable::sin(angle - turn * std::round(angle / turn)), std::sin(exact)));
  });
  EXPECT_LT(sine, 1.5);
  EXPECT_LT(cosine, 1.5);
  EXPECT_LT(tangent, 3);
  EXPECT_GT(naive, 1000) << "the test cannot tell a careless reduction from a good one";
}

TEST(Portable, InverseFunctionsAreWithinThreeUlp) {
  RecordProperty("seed", seed);
  double arc_sine = 0, arc_cosine = 0, arc_tangent = 0, naive = 0;
  for_ratios([&](double x) {
    const auto exact = static_cast<long double>(x);
    arc_sine = std::max(arc_sine, ulps(portable::asin(x), std::asin(exact)));
    arc_cosine = std::max(arc_cosine, ulps(portable::acos(x), std::acos(exact)));
    for (const double other : {-3.0, -0.7, 1e-5, 0.4, 2.0}) {
      const auto across = static_cast<long double>(other);
      arc_tangent = std::max(arc_tangent, ulps(portable::atan2(x, other), std::atan2(exact, across)));
    }
    naive = std::max(naive, ulps(portable::atan2(std::sqrt(1 - x * x), x), std::acos(exact)));
  });
  EXPECT_LT(arc_sine, 3);
  EXPECT_LT(arc_cosine, 3);
  EXPECT_LT(arc_tangent, 3);
  EXPECT_GT(naive, 1000) << "the test cannot tell a careless arc cosine from a good one";
}

TEST(Portable, LogarithmIsWithinOneAndAHalfUlp) {
  RecordProperty("seed", seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(-1000, 1000), near_one(0.5, 2);
  double worst = 0;
  for (int i = 0; i < 100000; ++i)
    for (const double x : {std::exp2(exponent(random)), near_one(random)})
      worst = std::max(worst, ulps(portable::log2(x), std::log2(static_cast<long double>(x))));
  EXPECT_LT(worst, 1.5);
}

TEST(Portable, SpecialValuesAreTheLibrarys) {
  const double values[] = {0.0, -0.0, 1.0, -1.0, 1e-310, 1e300, infinity, -infinity};
  for (const double x : values)
    for (const double y : values) {
      EXPECT_EQ(portable::atan2(y, x), std::atan2(y, x)) << y << ", " << x;
      EXPECT_EQ(std::signbit(portable::atan2(y, x)), std::signbit(std::atan2(y, x))) << y << ", " << x;
    }
  for (const double x : {0.0, -0.0, 1.0, -1.0, 1e-310}) {
    EXPECT_EQ(portable::asin(x), std::asin(x)) << x;
    EXPECT_EQ(portable::acos(x), std::acos(x)) << x;
    EXPECT_EQ(std::signbit(portable::sin(x)), std::signbit(x)) << x;
  }
  EXPECT_EQ(portable::cos(0), 1);
  EXPECT_EQ(portable::sin(0), 0);
  EXPECT_EQ(portable::log2(0x1p-1030), -1030);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {infinity, -infinity, nan}) {
    EXPECT_TRUE(std::isnan(portable::sin(x)) && std::isnan(portable::cos(x)) && std::isnan(portable::tan(x)));
    EXPECT_TRUE(std::isnan(portable::asin(x)) && std::isnan(portable::acos(x)));
  }
  EXPECT_TRUE(std::isnan(portable::atan2(nan, 1)) && std::isnan(portable::atan2(1, nan)));
  EXPECT_TRUE(std::isnan(portable::acos(1.1)));
}

// A check sum of all results' bits, as it came out on processors with and without fused multiply-add.
TEST(Portable, SameBitsOnEveryProcessor) {
  std::uint64_t sum = 0;
  const auto add = [&](double value) { sum = sum * 31 + std::bit_cast<std::uint64_t>(value); };
  for (int i = 1; i < 20000; ++i) {
    const double angle = i * 0.37e-3 - 3, ratio = i / 10000.0 - 1;
    for (const double value : {portable::sin(angle), portable::cos(angle), portable::tan(angle), portable::asin(ratio),
                               portable::acos(ratio), portable::atan2(angle, 0.3), portable::log2(i * 0.01)})
      add(value);
  }
  EXPECT_EQ(sum, 1526204074945964792u);
}

}  // namespace
}  // namespace ps::portable_test
