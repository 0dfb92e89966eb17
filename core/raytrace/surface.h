#pragma once
#include <cmath>

#include "raytrace/ray.h"
#include "raytrace/trace_inputs.h"
#include "raytrace/triangle_watertight.h"
#include "shade/illumination.h"

namespace ps {

/// The point that a ray hit, with all that shading needs.
template <class Real>
struct Surface {
  std::uint32_t primitive = no_primitive;
  Vec3<Real> point{0};
  Vec3<Real> geometric_normal{0};  ///< length 1; towards the front (conventions.h), outwards on spheres
  Vec3<Real> shading_normal{0};
  Vec3<Real> point_error{0};  ///< bound on the rounding error of `point` on a triangle, per axis
  Vec2<Real> uv{0};
  bool has_uv = false;
  bool back_face = false;
};

template <class Real>
inline Vec3<Real> normalised(const Vec3<Real>& v) {
  return v * (Real(1) / length(v));
}

/// A point of a sphere: the ray's point, and the direction from the centre (CGFS ch. 3).
template <class Real>
inline Surface<Real> sphere_surface(const Ray<Real>& ray, const Hit<Real>& hit, const TracedSphere<Real>& sphere) {
  Surface<Real> surface;
  surface.primitive = hit.primitive;
  surface.point = ray.origin + ray.direction * hit.t;
  surface.geometric_normal = normalised(surface.point - sphere.centre);
  surface.shading_normal = surface.geometric_normal;
  surface.back_face = dot(ray.direction, surface.geometric_normal) > 0;
  return surface;
}

/// The sum of three corner values by their weights, from left to right.
template <class Real, class Value>
inline Value blend(const std::array<Real, 3>& weights, const Value& a, const Value& b, const Value& c) {
  return a * weights[0] + b * weights[1] + c * weights[2];
}

/// A point of a triangle from its barycentric weights, which puts it nearer to the plane than origin + t * direction
/// does; the error bound is pbrt's (6.8).
template <class Real>
inline Surface<Real> triangle_surface(const Ray<Real>& ray, const Hit<Real>& hit, const TracedGeometry<Real>& geometry,
                                      const TracedTriangle<Real>& triangle, const Settings& settings) {
  Surface<Real> surface;
  surface.primitive = hit.primitive;
  const auto& w = hit.weights;
  surface.point = blend(w, triangle.a, triangle.b, triangle.c);
  for (int axis = 0; axis < 3; ++axis)
    surface.point_error[axis] =
        rounding_bound<Real>(7) *
        (std::abs(w[0] * triangle.a[axis]) + std::abs(w[1] * triangle.b[axis]) + std::abs(w[2] * triangle.c[axis]));
  surface.geometric_normal = normalised(cross(triangle.b - triangle.a, triangle.c - triangle.a));
  surface.shading_normal = surface.geometric_normal;
  surface.back_face = dot(ray.direction, surface.geometric_normal) > 0;
  if (triangle.attributes < 0) return surface;
  const auto& attributes = geometry.attributes[static_cast<std::size_t>(triangle.attributes)];
  if (attributes.has_normals && settings.normals == Normals::vertex) {
    const Vec3<Real> normal = blend(w, attributes.normals[0], attributes.normals[1], attributes.normals[2]);
    const Vec3<Real> unit = normalised(normal);
    const bool usable = dot(unit, unit) > 0;  // opposite normals may cancel to nothing
    if (usable) surface.shading_normal = settings.renormalise ? unit : normal;
  }
  surface.has_uv = attributes.has_uvs;
  if (surface.has_uv) surface.uv = blend(w, attributes.uvs[0], attributes.uvs[1], attributes.uvs[2]);
  return surface;
}

template <class Real>
inline Surface<Real> surface_of(const Ray<Real>& ray, const Hit<Real>& hit, const TraceInputs<Real>& inputs) {
  const TracedGeometry<Real>& geometry = *inputs.geometry;
  const Primitive& primitive = geometry.primitives[hit.primitive];
  switch (primitive.kind) {
  case PrimitiveKind::sphere:
    return sphere_surface(ray, hit, geometry.spheres[primitive.shape]);
  case PrimitiveKind::triangle:
    return triangle_surface(ray, hit, geometry, geometry.triangles[primitive.shape], inputs.settings);
  }
  return {};
}

}  // namespace ps
