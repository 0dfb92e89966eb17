#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "math/unit.h"

namespace ps {

/// Normal mapping in tangent space (CGFS ch. 15), shared by both renderers.
///
/// A normal map holds directions relative to the surface: x along growing u, y towards the top of the picture (falling
/// v, since v = 0 is the top row), z along the surface's own normal. Red, green and blue from 0 to 1 encode -1 to 1.

/// How a surface's texture lies on it: directions in which u grows and v falls, of any length.
template <class Real>
struct TangentFrame {
  Vec3<Real> along_u{0, 0, 0};
  Vec3<Real> upwards{0, 0, 0};
};

/// The power of two that brings a size near 1 where its products with others might leave the range of Real; else 1.
template <class Real>
inline Real factor_for_products(Real size) {
  if ((size > Real(0x1p-15) && size < Real(0x1p15)) || !(size > 0)) return 1;
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(Real(1), std::min(-exponent, std::numeric_limits<Real>::max_exponent - 1));
}

/// The frame of a triangle: dP/du and -dP/dv, which solve (b - a, c - a) = (dP/du, dP/dv) * (duv). Nothing if its
/// texture coordinates span no area.
template <class Real>
inline std::optional<TangentFrame<Real>> triangle_frame(const std::array<Vec3<Real>, 3>& p,
                                                        const std::array<Vec2<Real>, 3>& uv) {
  Vec3<Real> ab = p[1] - p[0], ac = p[2] - p[0];
  Vec2<Real> s = uv[1] - uv[0], t = uv[2] - uv[0];
  const Real length = factor_for_products(std::max(largest_component(ab), largest_component(ac)));
  const Real span = factor_for_products(std::max({std::abs(s.x), std::abs(s.y), std::abs(t.x), std::abs(t.y)}));
  ab *= length;
  ac *= length;
  s *= span;
  t *= span;
  const Real area = s.x * t.y - t.x * s.y;
  if (!(area != 0)) return {};
  const Real sign = area > 0 ? Real(1) : Real(-1);  // lengths do not matter, so the division by the area is left out
  return TangentFrame<Real>{(ab * t.y - ac * s.y) * sign, (ab * t.x - ac * s.x) * sign};
}

/// A texel as a direction in tangent space, not normalised: filtering shortens it.
template <class Real>
inline Vec3<Real> stored_normal(const Vec3<Real>& texel) {
  return texel * Real(2) - Vec3<Real>(1);
}

/// The axes of tangent space at a point: the tangent made perpendicular to the normal (Gram-Schmidt), the bitangent
/// perpendicular to both, on the side to which v falls.
template <class Real>
struct TangentSpace {
  Vec3<Real> tangent{1, 0, 0}, bitangent{0, 1, 0}, normal{0, 0, 1};  ///< length 1
};

/// Nothing where the tangent runs along the normal.
template <class Real>
inline std::optional<TangentSpace<Real>> tangent_space(const Vec3<Real>& normal, const TangentFrame<Real>& frame) {
  TangentSpace<Real> space;
  space.normal = unit_of(normal);
  const Vec3<Real> across = frame.along_u - space.normal * dot(space.normal, frame.along_u);
  if (!(largest_component(across) > 0)) return {};
  space.tangent = unit_of(across);
  const Vec3<Real> side = cross(space.normal, space.tangent);
  space.bitangent = dot(side, frame.upwards) < 0 ? -side : side;
  return space;
}

/// The map that placed a surface in the world, without its translation.
template <class Real>
struct Placing {
  Mat3<Real> to_world{Real(1)};  ///< of positions
  Mat3<Real> normals{Real(1)};   ///< of normals: the inverse transpose; both up to a factor, which does not matter
};

/// The matrix of cofactors is the inverse transpose times the determinant: it needs no division.
template <class Real>
inline Placing<Real> placing_of(const Mat3d& to_world) {
  const auto near_one = [](const Mat3d& m) {
    return m *
           factor_for_products(std::max({largest_component(m[0]), largest_component(m[1]), largest_component(m[2])}));
  };
  const Mat3d m = near_one(to_world);
  const Mat3d cofactors{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
  const double sense = dot(m[0], cofactors[0]) < 0 ? -1 : 1;
  return {Mat3<Real>(m), Mat3<Real>(near_one(cofactors * sense))};
}

/// The same axes made in the model, and brought to the world as normals are, by the inverse transpose (OCT). The normal
/// has length 1, the others any.
template <class Real>
inline std::optional<TangentSpace<Real>> tangent_space(const Vec3<Real>& normal, const TangentFrame<Real>& frame,
                                                       const Placing<Real>& placing) {
  // A vector before a matrix is multiplied by its transpose.
  auto space = tangent_space(normal * placing.to_world,
                             TangentFrame<Real>{frame.along_u * placing.normals, frame.upwards * placing.normals});
  if (!space) return {};
  const Real length = length_of(placing.normals * space->normal);
  if (!(length > 0)) return {};
  for (Vec3<Real>* axis : {&space->tangent, &space->bitangent, &space->normal})
    *axis = placing.normals * *axis / length;
  return space;
}

/// A stored normal in the world, of length 1; the surface's own where the map holds no usable one.
template <class Real>
inline Vec3<Real> mapped_normal(const TangentSpace<Real>& space, const Vec3<Real>& stored) {
  const Vec3<Real> turned = space.tangent * stored.x + space.bitangent * stored.y + space.normal * stored.z;
  return largest_component(turned) > 0 ? unit_of(turned) : space.normal;
}

}  // namespace ps
