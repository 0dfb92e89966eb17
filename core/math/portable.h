#pragma once

namespace ps::portable {

/// Trigonometric functions and a logarithm from basic operations in a fixed order. The C library computes its own with
/// or without fused multiply-adds, whichever the processor has, and they differ between its versions: the same call
/// gives other last bits elsewhere. What reaches a picture uses these, and power() (math/power.h).
///
/// Angles in radians. Results are off by less than 1.5 units in the last place (sin, cos, log2) or 3 (the others);
/// measured in tests. Zeros, infinities and NaN as in the C library.

/// Beyond 2^20 radians the angle is first reduced by the double next to 2 pi, which adds an error of 4e-17 times the
/// angle. NaN for infinite angles.
double sin(double angle);
double cos(double angle);
double tan(double angle);

/// NaN outside -1..1.
double asin(double x);
double acos(double x);

/// The angle of the point (x, y), from -pi to pi; 0 or pi for (0, 0), by the signs of its zeros.
double atan2(double y, double x);

/// For finite x > 0.
double log2(double x);

/// The same in double, rounded at the end.
inline float acos(float x) { return static_cast<float>(acos(static_cast<double>(x))); }
inline float atan2(float y, float x) {
  return static_cast<float>(atan2(static_cast<double>(y), static_cast<double>(x)));
}

}  // namespace ps::portable
