#pragma once
#include <algorithm>

#include "math/unit.h"

namespace ps {

inline double distance_to_segment(const Vec3d& point, const Vec3d& a, const Vec3d& b) {
  const Vec3d along = b - a;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(point - a, along) / square, 0.0, 1.0) : 0.0;
  return length_of(point - (a + along * share));
}

/// From a point to the nearest point of a triangle: the foot of the perpendicular if that lies in it, else on an edge.
inline double distance_to_triangle(const Vec3d& point, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d normal = unit_or_zero(triangle_normal(a, b, c));
  const auto is_left_of = [&](const Vec3d& from, const Vec3d& to) {
    return dot(cross(to - from, point - from), normal) >= 0;
  };
  if (normal != Vec3d(0) && is_left_of(a, b) && is_left_of(b, c) && is_left_of(c, a))
    return std::abs(dot(point - a, normal));
  return std::min(
      {distance_to_segment(point, a, b), distance_to_segment(point, b, c), distance_to_segment(point, c, a)});
}

}  // namespace ps
