#include "math/portable.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "math/double_double.h"
#include "math/power.h"

namespace ps::portable {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// pi / 2 in three parts. The first two have 33 bits, so that their products with numbers up to 2^20 are exact.
constexpr std::array<double, 3> half_pi_parts{0x1.921fb54400000p+0, 0x1.0b4611a600000p-34, 0x1.3198a2e037073p-69};
constexpr DoubleDouble half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr double two_pi = 0x1.921fb54442d18p+2;
constexpr double two_over_pi = 0.63661977236758138;
constexpr double largest_exact_angle = 0x1p20;

/// An angle as quarter * pi / 2 + rest, with the rest from -pi/4 to pi/4.
struct Reduced {
  int quarter;  ///< 0 to 3
  DoubleDouble rest;
};

Reduced reduce(double angle) {
  if (std::abs(angle) > largest_exact_angle) angle = std::fmod(angle, two_pi);
  const double n = (angle * two_over_pi + power_detail::round_to_integer) - power_detail::round_to_integer;
  const DoubleDouble rest = exact_sum(angle - n * half_pi_parts[0], -(n * half_pi_parts[1]));
  return {static_cast<int>(n) & 3, exact_sum(rest.high, rest.low - n * half_pi_parts[2])};
}

/// A polynomial in `x` by Horner's rule; the coefficient of the highest power comes first.
template <std::size_t count>
double horner(const std::array<double, count>& coefficients, double x) {
  double sum = coefficients[0];
  for (std::size_t i = 1; i < count; ++i) sum = sum * x + coefficients[i];
  return sum;
}

/// Taylor series for angles from -pi/4 to pi/4. What they leave out is below 2^-60 of the result.
double sin_near_zero(const DoubleDouble& angle) {
  constexpr std::array series{1.0 / 355687428096000.0, -1.0 / 1307674368000.0, 1.0 / 6227020800.0, -1.0 / 39916800.0,
                              1.0 / 362880.0,          -1.0 / 5040.0,          1.0 / 120.0,        -1.0 / 6.0};
  const double x = angle.high, z = x * x;
  return x + (x * z * horner(series, z) + angle.low * (1.0 - 0.5 * z));
}

double cos_near_zero(const DoubleDouble& angle) {
  constexpr std::array series{1.0 / 20922789888000.0, -1.0 / 87178291200.0, 1.0 / 479001600.0, -1.0 / 3628800.0,
                              1.0 / 40320.0,          -1.0 / 720.0,         1.0 / 24.0};
  const double x = angle.high, z = x * x;
  const double half = 0.5 * z, rough = 1.0 - half;
  return rough + (((1.0 - rough) - half) + (z * z * horner(series, z) - x * angle.low));
}

double sin_of(const Reduced& angle) {
  const double value = angle.quarter % 2 == 0 ? sin_near_zero(angle.rest) : cos_near_zero(angle.rest);
  return angle.quarter < 2 ? value : -value;
}

double cos_of(const Reduced& angle) { return sin_of({(angle.quarter + 1) & 3, angle.rest}); }

/// atan(i / 8).
constexpr std::array<DoubleDouble, 9> arc_tangents{{{0.0, 0.0},
                                                    {0.12435499454676144, -3.1253241424539383e-18},
                                                    {0.24497866312686414, 1.0698755618734451e-17},
                                                    {0.35877067027057225, -2.4623815582638635e-17},
                                                    {0.4636476090008061, 2.2698777452961687e-17},
                                                    {0.5585993153435624, -5.4556305485916264e-18},
                                                    {0.6435011087932844, 1.5834785051444286e-17},
                                                    {0.7188299996216245, -2.1478388444456983e-17},
                                                    {0.7853981633974483, 3.061616997868383e-17}}};

/// The arc tangent of a ratio from 0 to 1: atan(c) + atan((ratio - c) / (1 + c ratio)), with c the nearest eighth.
DoubleDouble atan_of_ratio(double ratio) {
  constexpr std::array series{1.0 / 13.0, -1.0 / 11.0, 1.0 / 9.0, -1.0 / 7.0, 1.0 / 5.0, -1.0 / 3.0};
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): from 0 to 8 only, and no call into the C library
  const int nearest = static_cast<int>(8.0 * ratio + 0.5);
  const double c = nearest / 8.0;
  const double t = (ratio - c) / (1.0 + c * ratio), z = t * t;
  return arc_tangents[static_cast<std::size_t>(nearest)] + DoubleDouble{t, t * z * horner(series, z)};
}

/// end - angle.
DoubleDouble back_from(const DoubleDouble& end, const DoubleDouble& angle) {
  return end + DoubleDouble{-angle.high, -angle.low};
}

}  // namespace

double sin(double angle) {
  if (!(std::abs(angle) < infinity)) return nan;
  return angle == 0 ? angle : sin_of(reduce(angle));
}

double cos(double angle) { return std::abs(angle) < infinity ? cos_of(reduce(angle)) : nan; }

double tan(double angle) {
  if (!(std::abs(angle) < infinity)) return nan;
  const Reduced reduced = reduce(angle);
  return angle == 0 ? angle : sin_of(reduced) / cos_of(reduced);
}

double asin(double x) { return atan2(x, std::sqrt((1.0 - x) * (1.0 + x))); }

double acos(double x) { return atan2(std::sqrt((1.0 - x) * (1.0 + x)), x); }

double atan2(double y, double x) {
  if (x != x || y != y) return nan;
  const double across = std::abs(x), up = std::abs(y);
  DoubleDouble angle;
  if (across == infinity && up == infinity)
    angle = arc_tangents.back();
  else if (up > across)
    angle = back_from(half_pi, atan_of_ratio(across / up));
  else if (across > 0)
    angle = atan_of_ratio(up / across);
  if (std::signbit(x)) angle = back_from({2 * half_pi.high, 2 * half_pi.low}, angle);
  return std::copysign(angle.high, y);
}

double log2(double x) { return power_detail::log2_positive(x).high; }

}  // namespace ps::portable
