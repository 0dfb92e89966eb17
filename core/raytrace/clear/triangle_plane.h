#pragma once
#include <cmath>

#include "raytrace/base/geometry.h"
#include "raytrace/clear/triangle_result.h"

namespace ps {

/// Where a line meets a triangle's plane (CGFS ch. 5): t, and the point relative to vertex a. Slopes up to `epsilon` in
/// size count as parallel.
template <class Real>
struct PlanePoint {
  Vec3<Real> normal{0};  ///< of twice the triangle's area in length
  Vec3<Real> from_a{0};
  Real t = 0;
  bool parallel = false;
};

template <class Real>
inline PlanePoint<Real> meet_plane(const Vec3<Real>& origin, const Vec3<Real>& direction,
                                   const TracedTriangle<Real>& triangle, Real epsilon) {
  PlanePoint<Real> point;
  point.normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  const Real slope = dot(point.normal, direction);
  point.parallel = !(std::abs(slope) > epsilon);
  if (point.parallel) return point;
  const Vec3<Real> s = origin - triangle.a;
  point.t = -dot(point.normal, s) / slope;
  point.from_a = s + direction * point.t;
  return point;
}

template <class Real>
inline TriangleResult<Real> judged_weights(Real t, const std::array<Real, 3>& weights) {
  TriangleResult<Real> result;
  result.t = t;
  result.weights = weights;
  if (weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0)
    result.verdict = TriangleVerdict::inside;
  else
    result.corner = weights[1] < 0 ? 1 : weights[2] < 0 ? 2 : 0;
  return result;
}

/// The plane, then on which side of each edge the point lies: the cross product of edge and point has to look the way
/// the normal does (CGFS ch. 5).
template <class Real>
inline TriangleResult<Real> triangle_cross_products(const Vec3<Real>& origin, const Vec3<Real>& direction,
                                                    const TracedTriangle<Real>& triangle, Real epsilon) {
  const PlanePoint<Real> point = meet_plane(origin, direction, triangle, epsilon);
  if (point.parallel) return {TriangleVerdict::parallel, 0, {}, -1};
  const Vec3<Real> b = triangle.b - triangle.a, c = triangle.c - triangle.a;
  const Real square = dot(point.normal, point.normal);
  const auto side = [&](const Vec3<Real>& edge, const Vec3<Real>& from_start) {
    return dot(cross(edge, from_start), point.normal) / square;
  };
  return judged_weights(point.t, {side(c - b, point.from_a - b), side(-c, point.from_a - c), side(b, point.from_a)});
}

/// The plane, then the weights of the point from the two equations that its dot products with the edges make.
template <class Real>
inline TriangleResult<Real> triangle_barycentric(const Vec3<Real>& origin, const Vec3<Real>& direction,
                                                 const TracedTriangle<Real>& triangle, Real epsilon) {
  const PlanePoint<Real> point = meet_plane(origin, direction, triangle, epsilon);
  if (point.parallel) return {TriangleVerdict::parallel, 0, {}, -1};
  const Vec3<Real> b = triangle.b - triangle.a, c = triangle.c - triangle.a;
  const Real bb = dot(b, b), bc = dot(b, c), cc = dot(c, c);
  const Real pb = dot(point.from_a, b), pc = dot(point.from_a, c);
  const Real determinant = bb * cc - bc * bc;
  const Real v = (cc * pb - bc * pc) / determinant, w = (bb * pc - bc * pb) / determinant;
  return judged_weights(point.t, {Real(1) - v - w, v, w});
}

}  // namespace ps
