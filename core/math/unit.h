#pragma once
#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace ps {

/// `v` divided by its length, as kernels compute it: in the type of `v`, and not for vectors whose square vanishes or
/// overflows there.
template <class Real>
inline Vec3<Real> unit(const Vec3<Real>& v) {
  return v / std::sqrt(dot(v, v));
}

/// The same with one division in place of three, as the ray tracer computes it: the last bits differ.
template <class Real>
inline Vec3<Real> normalised(const Vec3<Real>& v) {
  return v * (Real(1) / std::sqrt(dot(v, v)));
}

/// unit(); a vector whose square vanishes stays as it is.
template <class Real>
inline Vec3<Real> unit_or_zero(const Vec3<Real>& v) {
  const Real size = std::sqrt(dot(v, v));
  return size > 0 ? v / size : v;
}

inline double largest_component(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// `v` times the power of two that brings its largest component to 0.5 or more, but below 1: the same direction to the
/// last bit, with a square that neither vanishes nor overflows. Not for (0, 0, 0).
inline Vec3d brought_near_one(const Vec3d& v) {
  int exponent = 0;
  std::frexp(largest_component(v), &exponent);
  return {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
}

/// Squares of vectors between these limits keep their digits.
inline constexpr double least_exact_square = 1e-280, greatest_exact_square = 1e280;
inline bool has_exact_square(double square) { return square > least_exact_square && square < greatest_exact_square; }

/// The length of `v`, also where its square is too small or too large for a double.
inline double length_of(const Vec3d& v) {
  const double square = dot(v, v);
  if (has_exact_square(square) || v == Vec3d{0, 0, 0}) return std::sqrt(square);
  int exponent = 0;
  std::frexp(largest_component(v), &exponent);
  const Vec3d scaled = brought_near_one(v);
  return std::ldexp(std::sqrt(dot(scaled, scaled)), exponent);
}

/// The direction of `v`, with length 1, also where its square is too small or too large for a double. Not for
/// (0, 0, 0), which has none.
inline Vec3d unit_of(const Vec3d& v) {
  const double square = dot(v, v);
  if (has_exact_square(square)) return v / std::sqrt(square);
  const Vec3d scaled = brought_near_one(v);
  return scaled / std::sqrt(dot(scaled, scaled));
}

/// `v` as it is, or brought near one where a float could not hold its square: renderers work in float, and of most
/// directions the length means nothing. Not for (0, 0, 0).
inline Vec3d float_direction(const Vec3d& v) { return largest_component(v) < 0x1p-30 ? brought_near_one(v) : v; }

}  // namespace ps
