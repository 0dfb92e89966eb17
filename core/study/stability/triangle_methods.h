#pragma once
#include "study/stability/aimed_rays.h"
#include "study/stability/build_flags/kernels.h"

namespace ps::stability {

/// The same numbers without types of the program, for kernels that are compiled with other flags.
inline FlagTriangle flat(const TracedTriangle<float>& t) {
  return {{{t.a.x, t.a.y, t.a.z}, {t.b.x, t.b.y, t.b.z}, {t.c.x, t.c.y, t.c.z}}};
}
inline FlagRay flat(const AimedRay& ray) {
  return {{ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z}};
}

/// Ray and triangle as CGPP's listing 15.16 has it, in float: determinants up to 1e-7 in size are parallel, weights may
/// fall to -1e-10, and what is left of the origin is divided by the determinant before the products.
bool cgpp_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);

/// Side of the ray's line on which each edge passes, by Pluecker coordinates. A side counts as 0 up to `ulps` times the
/// size of the sum of the three.
TriangleHits pluecker_hits(float ulps);

/// The program's tests that meet the triangle's plane first.
bool plane_barycentric_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);
bool plane_cross_products_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);

/// The watertight test without the fallback to double where an edge function is 0, as the program is compiled.
bool float_only_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);
/// The same with each edge function a b - c d fused to one rounding and a product rounded before, but not the shear.
bool fused_edges_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);

}  // namespace ps::stability
