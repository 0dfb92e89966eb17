#pragma once
#include <array>
#include <cmath>

#include "accel/box.h"

namespace ps {

/// Do a triangle and a box, grown by `slack` on all sides, overlap? They are apart if and only if one of 13 axes
/// separates them: the box's three, the triangle's normal, and the nine cross products of their edges (Akenine-Moeller
/// 2001).
inline bool triangle_overlaps_box(const std::array<Vec3d, 3>& corners, const Box<double>& box, double slack) {
  const Vec3d middle = (box.low + box.high) * 0.5;
  const Vec3d half = (box.high - box.low) * 0.5 + slack;
  const std::array<Vec3d, 3> p{corners[0] - middle, corners[1] - middle, corners[2] - middle};
  const std::array<Vec3d, 3> edges{p[1] - p[0], p[2] - p[1], p[0] - p[2]};
  const auto separates = [&](const Vec3d& axis) {
    const double a = dot(axis, p[0]), b = dot(axis, p[1]), c = dot(axis, p[2]);
    const double reach = std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z;
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
  };
  const std::array<Vec3d, 3> axes{Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
  for (const Vec3d& axis : axes)
    if (separates(axis)) return false;
  if (separates(cross(edges[0], edges[1]))) return false;
  for (const Vec3d& axis : axes)
    for (const Vec3d& edge : edges)
      if (separates(cross(axis, edge))) return false;
  return true;
}

}  // namespace ps
