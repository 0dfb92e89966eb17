#pragma once
#include "study/stability/aimed_rays.h"

namespace ps::stability {

/// Ray and triangle as CGPP's listing 15.16 has it, in float: determinants up to 1e-7 in size are parallel, weights may
/// fall to -1e-10, and what is left of the origin is divided by the determinant before the products.
bool cgpp_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);

/// The program's tests that meet the triangle's plane first.
bool plane_barycentric_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);
bool plane_cross_products_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);

/// The watertight test without the fallback to double where an edge function is 0.
bool float_only_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);

}  // namespace ps::stability
