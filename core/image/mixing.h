#pragma once
#include "math/vec.h"

namespace ps {

/// Mixing colours as in CGFS ch. 1; 1.0 is the book's 255. No value is clamped until it is asked for, so that light can
/// add up before it is shown.

/// Light added to light: red and green make yellow.
template <class Real>
Vec3<Real> mix_additive(const Vec3<Real>& below, const Vec3<Real>& above) {
  return {below.r + above.r, below.g + above.g, below.b + above.b};
}

/// A filter or ink over a colour takes light away: what passes is the product. Yellow over cyan makes green.
template <class Real>
Vec3<Real> mix_subtractive(const Vec3<Real>& below, const Vec3<Real>& above) {
  return {below.r * above.r, below.g * above.g, below.b * above.b};
}

/// Each channel cut to [0, 1]; NaN becomes 0.
template <class Real>
Vec3<Real> clamp_colour(const Vec3<Real>& colour) {
  const auto cut = [](Real value) { return value > 0 ? (value < 1 ? value : Real(1)) : Real(0); };
  return {cut(colour.r), cut(colour.g), cut(colour.b)};
}

}  // namespace ps
