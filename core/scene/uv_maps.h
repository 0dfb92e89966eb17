#pragma once
#include <algorithm>
#include <numbers>

#include "math/portable.h"
#include "math/vec.h"

namespace ps {

/// Texture coordinates of primitives, the same for rays and for tessellation. v = 0 is the top of the picture.

/// A map of the world around a sphere, by the unit direction from its centre: the north pole is +y; the centre of the
/// map looks to -z, its right half to +x. The seam is at +z.
template <class Real>
inline Vec2<Real> world_map_uv(const Vec3<Real>& direction) {
  constexpr Real pi = std::numbers::pi_v<Real>;
  const Real polar = portable::acos(std::clamp(direction.y, Real(-1), Real(1)));
  return {Real(0.5) + portable::atan2(direction.x, -direction.z) / (2 * pi), polar / pi};
}

/// Faces of a box: 0 = -x, 1 = +x, 2 = -y, 3 = +y, 4 = -z, 5 = +z, in its own axes.
/// The cross of a folded-out cube, 4 cells wide and 3 high: in the middle row left, front, right, back; the top above
/// and the bottom below the front, which is -z. `p` is the point with the half edges as unit, so -1 to 1.
template <class Real>
inline Vec2<Real> cube_cross_uv(int face, const Vec3<Real>& p) {
  const Vec3<Real> s = (p + Real(1)) * Real(0.5);  // 0 to 1
  Vec2<Real> cell{1, 1}, within{s.x, 1 - s.y};
  if (face == 0) cell = {0, 1}, within = {1 - s.z, 1 - s.y};
  if (face == 1) cell = {2, 1}, within = {s.z, 1 - s.y};
  if (face == 2) cell = {1, 2}, within = {s.x, s.z};
  if (face == 3) cell = {1, 0}, within = {s.x, 1 - s.z};
  if (face == 5) cell = {3, 1}, within = {1 - s.x, 1 - s.y};
  return {(cell.x + within.x) / 4, (cell.y + within.y) / 3};
}

/// Faces of a cylinder: 0 = cap at `from`, 1 = cap at `to`, 2 = side. `p` has the radius and the height as units, with
/// z from 0 to 1 along the axis. The side is the whole picture, rolled up with `to` at the top; so is each cap.
template <class Real>
inline Vec2<Real> cylinder_uv(int face, const Vec3<Real>& p) {
  if (face == 2) return {Real(0.5) + portable::atan2(p.y, p.x) / (2 * std::numbers::pi_v<Real>), 1 - p.z};
  return {(1 + p.x) / 2, (1 - p.y) / 2};
}

}  // namespace ps
