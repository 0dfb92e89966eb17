#pragma once
#include <cmath>

#include "raytrace/base/geometry.h"
#include "raytrace/clear/triangle_result.h"

namespace ps {

/// Ray and triangle by Cramer's rule (Moeller and Trumbore 1997; CGPP 15.4.3). Determinants up to `epsilon` in size
/// count as parallel. Neighbours compute a shared edge differently, so rays aimed at it may slip through.
template <class Real>
inline TriangleResult<Real> triangle_moeller_trumbore(const Vec3<Real>& origin, const Vec3<Real>& direction,
                                                      const TracedTriangle<Real>& triangle, Real epsilon) {
  TriangleResult<Real> result;
  const Vec3<Real> edge_b = triangle.b - triangle.a;
  const Vec3<Real> edge_c = triangle.c - triangle.a;
  const Vec3<Real> p = cross(direction, edge_c);
  const Real determinant = dot(edge_b, p);
  if (!(std::abs(determinant) > epsilon)) {
    result.verdict = TriangleVerdict::parallel;
    return result;
  }
  const Vec3<Real> s = origin - triangle.a;
  const Vec3<Real> q = cross(s, edge_b);
  const Real u = dot(s, p) / determinant;
  const Real v = dot(direction, q) / determinant;
  result.weights = {Real(1) - u - v, u, v};
  result.t = dot(edge_c, q) / determinant;
  const bool inside = u >= 0 && v >= 0 && u + v <= 1;  // false for NaN
  if (inside)
    result.verdict = TriangleVerdict::inside;
  else
    result.corner = u < 0 ? 1 : v < 0 ? 2 : 0;
  return result;
}

}  // namespace ps
