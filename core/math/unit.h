#pragma once
#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace ps {

/// Squares of vectors between `least` and `greatest` keep their digits. Vectors beyond are squared times `up` or
/// `down`, powers of two, which change no digit. The same in SIMD (math/vec3-inl.h).
template <class Real>
struct ExactSquares;
template <>
struct ExactSquares<float> {
  static constexpr float least = 0x1p-100f, greatest = 0x1p100f, up = 0x1p100f, down = 0x1p-100f;
};
template <>
struct ExactSquares<double> {
  static constexpr double least = 0x1p-930, greatest = 0x1p930, up = 0x1p600, down = 0x1p-600;
};

template <class Real>
inline bool has_exact_square(Real square) {
  return square > ExactSquares<Real>::least && square < ExactSquares<Real>::greatest;
}

/// The factor that brings a vector with this square near enough to 1 to be squared; 1 for nearly all.
template <class Real>
inline Real factor_for_square(Real square) {
  if (has_exact_square(square)) [[likely]]
    return Real(1);
  return square < Real(1) ? ExactSquares<Real>::up : ExactSquares<Real>::down;
}

/// The length of `v`, also where its square is too small or too large for its type.
template <class Real>
inline Real length_of(const Vec3<Real>& v) {
  const Real square = dot(v, v);
  if (has_exact_square(square)) [[likely]]
    return std::sqrt(square);
  const Real factor = factor_for_square(square);
  const Vec3<Real> near_one = v * factor;
  return std::sqrt(dot(near_one, near_one)) / factor;
}

/// The direction of `v`, with length 1, also where its square is too small or too large for its type. (0, 0, 0) has
/// none, and becomes NaN.
template <class Real>
inline Vec3<Real> unit_of(const Vec3<Real>& v) {
  const Real square = dot(v, v);
  if (has_exact_square(square)) [[likely]]
    return v / std::sqrt(square);
  const Vec3<Real> near_one = v * factor_for_square(square);
  return near_one / std::sqrt(dot(near_one, near_one));
}

/// The same with one division in place of three, as the ray tracer computes it: the last bits differ.
template <class Real>
inline Vec3<Real> normalised(const Vec3<Real>& v) {
  const Real square = dot(v, v);
  if (has_exact_square(square)) [[likely]]
    return v * (Real(1) / std::sqrt(square));
  const Vec3<Real> near_one = v * factor_for_square(square);
  return near_one * (Real(1) / std::sqrt(dot(near_one, near_one)));
}

/// unit_of(); (0, 0, 0) stays as it is.
template <class Real>
inline Vec3<Real> unit_or_zero(const Vec3<Real>& v) {
  const Real size = length_of(v);
  return size > 0 ? unit_of(v) : v;
}

template <class Real>
inline Real largest_component(const Vec3<Real>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// `v` times the power of two that brings its largest component to 0.5 or more, but below 1: the same direction to the
/// last bit, with a square that neither vanishes nor overflows. Not for (0, 0, 0).
template <class Real>
inline Vec3<Real> brought_near_one(const Vec3<Real>& v) {
  int exponent = 0;
  std::frexp(largest_component(v), &exponent);
  return {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
}

/// The normal of the triangle a, b, c by its sense: cross(b - a, c - a), whose length is twice the area. Where its
/// square would vanish or overflow, one of the same direction and another length. (0, 0, 0): there is no area.
template <class Real>
inline Vec3<Real> triangle_normal(const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) {
  const Vec3<Real> to_b = b - a, to_c = c - a;
  const Vec3<Real> normal = cross(to_b, to_c);
  if (has_exact_square(dot(normal, normal))) [[likely]]
    return normal;
  if (!(largest_component(to_b) > 0 && largest_component(to_c) > 0)) return normal;
  // In double, where products of floats are exact: nearly parallel edges must not cancel to 0.
  const Vec3d exact = cross(Vec3d(brought_near_one(to_b)), Vec3d(brought_near_one(to_c)));
  return Vec3<Real>(largest_component(exact) > 0 ? brought_near_one(exact) : exact);
}

/// `v` as it is, or brought near one where a float could not hold its square: renderers work in float, and of most
/// directions the length has no meaning. Not for (0, 0, 0).
inline Vec3d float_direction(const Vec3d& v) { return largest_component(v) < 0x1p-30 ? brought_near_one(v) : v; }

}  // namespace ps
