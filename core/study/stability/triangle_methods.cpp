#include "study/stability/triangle_methods.h"

#include <cmath>

#include "raytrace/clear/triangle_plane.h"
#include "raytrace/clear/triangle_watertight.h"

namespace ps::stability {

bool cgpp_hits(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const Vec3f edge_b = triangle.b - triangle.a, edge_c = triangle.c - triangle.a;
  const Vec3f q = cross(ray.direction, edge_c);
  const float determinant = dot(edge_b, q);
  if (!(std::abs(determinant) > 1e-7f)) return false;
  const Vec3f s = (ray.origin - triangle.a) / determinant;
  const Vec3f r = cross(s, edge_b);
  const float u = dot(s, q), v = dot(r, ray.direction), w = 1 - u - v;
  constexpr float least = -1e-10f;
  return u >= least && v >= least && w >= least && dot(edge_c, r) > 0;
}

bool plane_barycentric_hits(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const auto result = triangle_barycentric<float>(ray.origin, ray.direction, triangle, 0);
  return result.verdict == TriangleVerdict::inside && result.t > 0;
}

bool plane_cross_products_hits(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const auto result = triangle_cross_products<float>(ray.origin, ray.direction, triangle, 0);
  return result.verdict == TriangleVerdict::inside && result.t > 0;
}

bool float_only_hits(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const Shear<float> shear(ray.direction);
  const auto sheared = [&](const Vec3f& corner) {
    const float far = corner[shear.kz] - ray.origin[shear.kz];
    return Vec2f(corner[shear.kx] - ray.origin[shear.kx] - shear.x * far,
                 corner[shear.ky] - ray.origin[shear.ky] - shear.y * far);
  };
  const Vec2f a = sheared(triangle.a), b = sheared(triangle.b), c = sheared(triangle.c);
  const auto edge = [](const Vec2f& p, const Vec2f& q) { return p.x * q.y - p.y * q.x; };
  const float u = edge(c, b), v = edge(a, c), w = edge(b, a);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

}  // namespace ps::stability
