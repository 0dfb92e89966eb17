#pragma once
#include <cmath>

#include "math/unit.h"
#include "raytrace/base/ray.h"
#include "raytrace/base/trace_inputs.h"
#include "raytrace/clear/csg.h"
#include "raytrace/clear/triangle_watertight.h"
#include "scene/uv_maps.h"
#include "shade/illumination.h"

namespace ps {

/// The point that a ray hit, with all that shading needs.
template <class Real>
struct SurfacePoint {
  std::uint32_t primitive = no_primitive;
  std::uint32_t detail = 0;    ///< of the hit
  std::uint32_t material = 0;  ///< index into Scene::materials
  Vec3<Real> point{0};
  Vec3<Real> geometric_normal{0};  ///< length 1; towards the front (conventions.h), outwards on spheres
  Vec3<Real> shading_normal{0};
  Vec3<Real> point_error{0};  ///< bound on the rounding error of `point` on a triangle, per axis
  Vec2<Real> uv{0};
  bool has_uv = false;
  bool back_face = false;
};

/// `normal`; where the point that was hit lies right in the centre, so that it has no direction, one towards the ray.
template <class Real>
inline Vec3<Real> normal_towards(const Ray<Real>& ray, const Vec3<Real>& normal) {
  return has_nan(normal) ? normalised(-ray.direction) : normal;
}

/// A point of a sphere: the ray's point, and the direction from the centre (CGFS ch. 3).
template <class Real>
inline SurfacePoint<Real> sphere_surface(const Ray<Real>& ray, const Hit<Real>& hit, const TracedSphere<Real>& sphere,
                                         bool has_uv) {
  SurfacePoint<Real> surface;
  surface.primitive = hit.primitive;
  surface.detail = hit.detail;
  surface.point = ray.origin + ray.direction * hit.t;
  surface.geometric_normal = normal_towards(ray, normalised(surface.point - sphere.centre));
  surface.shading_normal = surface.geometric_normal;
  surface.back_face = dot(ray.direction, surface.geometric_normal) > 0;
  surface.has_uv = has_uv;
  if (has_uv) surface.uv = world_map_uv(surface.geometric_normal);
  return surface;
}

/// The sum of three vertex values by their weights, from left to right.
template <class Real, class Value>
inline Value blend(const std::array<Real, 3>& weights, const Value& a, const Value& b, const Value& c) {
  return a * weights[0] + b * weights[1] + c * weights[2];
}

/// A point of a triangle from its barycentric weights, which puts it nearer to the plane than origin + t * direction
/// does; the error bound is pbrt's (6.8). Of a triangle that is tested in double, whose weights float rounds too
/// coarsely, it is the ray's point.
template <class Real>
inline void put_triangle_surface(const Ray<Real>& ray, const Hit<Real>& hit, const TracedGeometry<Real>& geometry,
                                 const Primitive& primitive, const TracedTriangle<Real>& triangle,
                                 const Settings& settings, SurfacePoint<Real>& surface) {
  surface = {};
  surface.primitive = hit.primitive;
  const auto& w = hit.weights;
  const bool in_double = primitive.in_double && asks_for_double(triangle, geometry.near_plane);
  surface.point = in_double ? ray.origin + ray.direction * hit.t : blend(w, triangle.a, triangle.b, triangle.c);
  for (int axis = 0; axis < 3; ++axis)
    surface.point_error[axis] =
        in_double ? rounding_bound<Real>(3) * (std::abs(ray.origin[axis]) + std::abs(ray.direction[axis] * hit.t))
                  : rounding_bound<Real>(7) * (std::abs(w[0] * triangle.a[axis]) + std::abs(w[1] * triangle.b[axis]) +
                                               std::abs(w[2] * triangle.c[axis]));
  surface.geometric_normal = normalised(triangle_normal(triangle.a, triangle.b, triangle.c));
  if (primitive.mirrored) surface.geometric_normal = -surface.geometric_normal;
  surface.shading_normal = surface.geometric_normal;
  surface.back_face = dot(ray.direction, surface.geometric_normal) > 0;
  if (triangle.attributes < 0) return;
  TriangleAttributes<Real> placed_ones;
  const TriangleAttributes<Real>& attributes = attributes_of(geometry, primitive, triangle, placed_ones);
  if (attributes.has_normals && settings.normals == Normals::vertex) {
    const Vec3<Real> normal = blend(w, attributes.normals[0], attributes.normals[1], attributes.normals[2]);
    const Vec3<Real> unit = normalised(normal);
    const bool usable = dot(unit, unit) > 0;  // opposite normals may cancel to nothing
    if (usable) surface.shading_normal = settings.renormalise ? unit : normal;
  }
  surface.has_uv = attributes.has_uvs;
  if (surface.has_uv) surface.uv = blend(w, attributes.uvs[0], attributes.uvs[1], attributes.uvs[2]);
}

/// The outward normal of a form on its face `face`, at `p` relative to its centre; length 1.
template <class Real>
inline Vec3<Real> form_normal(const TracedForm<Real>& form, int face, const Vec3<Real>& p) {
  switch (form.kind) {
  case FormKind::ball:
    return normalised(p);
  case FormKind::plane:
  case FormKind::rectangle:
    return form.axes[2];
  case FormKind::brick: {
    const Vec3<Real>& axis = form.axes[static_cast<std::size_t>(face / 2)];
    return face % 2 == 0 ? -axis : axis;
  }
  case FormKind::cylinder:
    if (face == 0) return -form.axes[2];
    if (face == 1) return form.axes[2];
    return normalised(p - form.axes[2] * dot(p, form.axes[2]));
  }
  return {};
}

template <class Real>
inline Vec2<Real> form_uv(const TracedForm<Real>& form, int face, const Vec3<Real>& p) {
  const Vec3<Real> local = in_frame(form, p);
  switch (form.kind) {
  case FormKind::ball:
    return world_map_uv(normalised(p));
  case FormKind::plane:
    return {local.x, -local.y};  // one picture for each unit of the world
  case FormKind::rectangle:
    return {local.x / form.half.x, 1 - local.y / form.half.y};
  case FormKind::brick:
    return cube_cross_uv(face, local / form.half);
  case FormKind::cylinder:
    return cylinder_uv(face, local / form.half);
  }
  return {};
}

/// A point of a solid. Flat forms on their own turn their normal to the ray, unless they have only a front.
template <class Real>
inline SurfacePoint<Real> solid_surface(const Ray<Real>& ray, const Hit<Real>& hit,
                                        const TracedGeometry<Real>& geometry, const TracedSolid& solid) {
  const TracedForm<Real>& form = geometry.forms[solid.first_form + detail_part(hit.detail)];
  const int face = detail_face(hit.detail);
  SurfacePoint<Real> surface;
  surface.primitive = hit.primitive;
  surface.detail = hit.detail;
  surface.material = form.material;
  surface.point = ray.origin + ray.direction * hit.t;
  const TracedPlace<Real>* place = form.place < 0 ? nullptr : &geometry.places[static_cast<std::size_t>(form.place)];
  const Vec3<Real> p = (place ? place->point(surface.point) : surface.point) - form.centre;
  surface.geometric_normal = normal_towards(ray, form_normal(form, face, p));
  if (place) surface.geometric_normal = normalised(place->normal_to_world(surface.geometric_normal));
  const bool flat = solid.steps == 0 && (form.kind == FormKind::plane || form.kind == FormKind::rectangle);
  if (flat ? dot(ray.direction, surface.geometric_normal) > 0 : detail_turned(hit.detail))
    surface.geometric_normal = -surface.geometric_normal;
  surface.shading_normal = surface.geometric_normal;
  surface.back_face = dot(ray.direction, surface.geometric_normal) > 0;
  surface.uv = form_uv(form, face, p);
  surface.has_uv = true;
  return surface;
}

/// What a hit shows: of CSG objects the part is where others have the triangle.
template <class Real>
inline PixelId id_of(const TracedGeometry<Real>& geometry, const Hit<Real>& hit) {
  const Primitive primitive = primitive_of(geometry, hit.primitive);
  PixelId id = primitive.id;
  if (primitive.kind == PrimitiveKind::solid) id.triangle = static_cast<std::int32_t>(detail_part(hit.detail));
  return id;
}

/// Fills `surface`, in its place, since it is large, with what a ray found.
template <class Real>
inline void put_surface(const Ray<Real>& ray, const Hit<Real>& hit, const TraceInputs<Real>& inputs,
                        SurfacePoint<Real>& surface) {
  const TracedGeometry<Real>& geometry = *inputs.geometry;
  const Primitive primitive = primitive_of(geometry, hit.primitive);
  switch (primitive.kind) {
  case PrimitiveKind::sphere:
    surface = sphere_surface(ray, hit, geometry.spheres[primitive.shape], inputs.maps_spheres);
    surface.material = primitive.material;
    break;
  case PrimitiveKind::triangle: {
    TracedTriangle<Real> placed;
    put_triangle_surface(ray, hit, geometry, primitive, triangle_of(geometry, primitive, placed), inputs.settings,
                         surface);
    surface.material = primitive.material;
    break;
  }
  case PrimitiveKind::solid:
    surface = solid_surface(ray, hit, geometry, geometry.solids[primitive.shape]);
    break;
  }
}

template <class Real>
inline SurfacePoint<Real> surface_of(const Ray<Real>& ray, const Hit<Real>& hit, const TraceInputs<Real>& inputs) {
  SurfacePoint<Real> surface;
  put_surface(ray, hit, inputs, surface);
  return surface;
}

}  // namespace ps
