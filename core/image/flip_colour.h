#pragma once
#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace ps::flip_colour {

/// Colour spaces of FLIP. White is linear RGB (1, 1, 1) under D65; XYZ are relative to that white, component by
/// component.

/// Rows of linear sRGB to XYZ, from the primaries of IEC 61966-2-1.
inline Mat3d rgb_to_xyz() {
  constexpr double x = 24577794.0, y = 12288897.0, z = 73733382.0;
  return glm::transpose(Mat3d(10135552 / x, 8788810 / x, 4435075 / x,  //
                              2613072 / y, 8788810 / y, 887015 / y,    //
                              1425312 / z, 8788810 / z, 70074185 / z));
}

inline Vec3d relative_xyz(const Vec3d& rgb) {
  static const Mat3d matrix = rgb_to_xyz();
  static const Vec3d white = matrix * Vec3d(1);
  return (matrix * rgb) / white;
}

inline Vec3d rgb_of_relative_xyz(const Vec3d& xyz) {
  static const Mat3d inverse = glm::inverse(rgb_to_xyz());
  static const Vec3d white = rgb_to_xyz() * Vec3d(1);
  return inverse * (xyz * white);
}

/// Linear opponent colours: achromatic, red-green, blue-yellow.
inline Vec3d opponent(const Vec3d& rgb) {
  const Vec3d t = relative_xyz(rgb);
  return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}

inline Vec3d rgb_of_opponent(const Vec3d& c) {
  const double y = (c.x + 16) / 116;
  return rgb_of_relative_xyz({y + c.y / 500, y, y - c.z / 200});
}

/// CIELAB, its colourfulness scaled with lightness (Hunt): dark colours look less colourful.
inline Vec3d hunt_lab(const Vec3d& rgb) {
  constexpr double delta = 6.0 / 29.0;
  const auto f = [](double t) {
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29.0;
  };
  const Vec3d t = relative_xyz(rgb);
  const double lightness = 116 * f(t.y) - 16;
  const double scale = 0.01 * lightness;
  return {lightness, scale * 500 * (f(t.x) - f(t.y)), scale * 200 * (f(t.y) - f(t.z))};
}

/// Distance for large differences: lightness by itself, the two chroma axes together.
inline double hyab(const Vec3d& a, const Vec3d& b) {
  const Vec3d d = a - b;
  return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

}  // namespace ps::flip_colour
