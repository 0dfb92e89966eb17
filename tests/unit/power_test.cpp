// power() against the C library in a wider type: the error in units of the last place, and the exact cases.
#include "math/power.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace power_test {
namespace {

/// Distance in units of the last place of `truth` rounded to Real.
template <class Real>
double ulps(Real found, long double truth) {
  const Real rounded = static_cast<Real>(truth);
  if (found == rounded) return 0;
  const Real unit = std::nextafter(std::abs(rounded), std::numeric_limits<Real>::infinity()) - std::abs(rounded);
  return static_cast<double>(std::abs(static_cast<long double>(found) - truth) / static_cast<long double>(unit));
}

/// The largest error over highlights (x in (0, 1], exponents up to 1000) and over the whole range of the type.
template <class Real, class Function>
double largest_error(Function function, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<Real> unit(0, 1);
  double worst = 0;
  const auto probe = [&](Real x, Real y) {
    const long double truth = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    if (truth < std::numeric_limits<Real>::min() || truth > std::numeric_limits<Real>::max()) return;
    worst = std::max(worst, ulps(function(x, y), truth));
  };
  for (int i = 0; i < 200000; ++i) {
    probe(1 - unit(random) * unit(random) * unit(random), unit(random) * 1000);
    const Real range = std::numeric_limits<Real>::max_exponent;
    const Real x = std::exp2(range * (2 * unit(random) - 1));
    probe(x, range * (2 * unit(random) - 1) / std::log2(x));
    probe(unit(random) * 2, 50);
  }
  return worst;
}

TEST(Power, FloatIsWithinOneUlp) {
  constexpr unsigned seed = 1;
  RecordProperty("seed", seed);
  EXPECT_LT(largest_error<float>([](float x, float y) { return ps::power(x, y); }, seed), 1.0);
  const auto naive = [](float x, float y) { return std::exp2(y * std::log2(x)); };
  EXPECT_GT(largest_error<float>(naive, seed), 20.0) << "the test cannot tell a rough power from a good one";
}

TEST(Power, DoubleIsWithinFourUlp) {
  constexpr unsigned seed = 2;
  RecordProperty("seed", seed);
  EXPECT_LT(largest_error<double>([](double x, double y) { return ps::power(x, y); }, seed), 4.0);
  const auto naive = [](double x, double y) { return std::exp2(y * std::log2(x)); };
  EXPECT_GT(largest_error<double>(naive, seed), 20.0) << "the test cannot tell a rough power from a good one";
}

template <class Real>
void expect_exact_cases() {
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  constexpr Real least = std::numeric_limits<Real>::denorm_min();
  for (const Real x : {Real(0), Real(0.3), Real(1), Real(7), infinity}) EXPECT_EQ(ps::power(x, Real(0)), 1);
  for (const Real y : {Real(-3), Real(0.3), Real(1), Real(500), infinity}) EXPECT_EQ(ps::power(Real(1), y), 1);
  EXPECT_EQ(ps::power(Real(0), Real(0.5)), 0);
  EXPECT_EQ(ps::power(Real(0), Real(-1)), infinity);
  EXPECT_EQ(ps::power(Real(0.5), Real(1e6)), 0);
  EXPECT_EQ(ps::power(Real(2), Real(1e6)), infinity);
  EXPECT_EQ(ps::power(Real(2), Real(10)), 1024);
  EXPECT_EQ(ps::power(least, Real(1)), least);
  EXPECT_EQ(ps::power(Real(0.5), infinity), 0);
  EXPECT_TRUE(std::isnan(ps::power(Real(-1), Real(2))));
  EXPECT_TRUE(std::isnan(ps::power(Real(2), std::numeric_limits<Real>::quiet_NaN())));
}

TEST(Power, SpecialValues) {
  expect_exact_cases<float>();
  expect_exact_cases<double>();
}

}  // namespace
}  // namespace power_test
