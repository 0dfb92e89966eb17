#pragma once
#include "raytrace/base/ray.h"
#include "raytrace/clear/triangle_moeller_trumbore.h"
#include "raytrace/clear/triangle_plane.h"
#include "raytrace/clear/triangle_watertight.h"

namespace ps {

/// A ray as the tests take it.
template <class Real>
struct TriangleQuery {
  const Ray<Real>& ray;
  const Shear<Real>& shear;
  Real epsilon = 0;  ///< option triangle-epsilon
};

/// The test that the settings name. The ray does not start on this triangle.
template <class Real>
inline TriangleResult<Real> triangle_result(TriangleTest test, const TriangleQuery<Real>& query,
                                            const TracedTriangle<Real>& triangle) {
  const Ray<Real>& ray = query.ray;
  switch (test) {
  case TriangleTest::watertight:
    return triangle_watertight(ray.origin, query.shear, triangle,
                               ray.start == no_primitive || ray.excludes_start ? TriangleGuard::none
                                                                               : TriangleGuard::rounding_of_t);
  case TriangleTest::moeller_trumbore:
    return triangle_moeller_trumbore(ray.origin, ray.direction, triangle, query.epsilon);
  case TriangleTest::barycentric:
    return triangle_barycentric(ray.origin, ray.direction, triangle, query.epsilon);
  case TriangleTest::cross_products:
    return triangle_cross_products(ray.origin, ray.direction, triangle, query.epsilon);
  }
  return {};
}

}  // namespace ps
