#pragma once
#include <optional>

#include "raytrace/surface.h"
#include "shade/normal_mapping.h"

namespace ps {

/// How a form's texture lies on it at `p` relative to its centre (uv_maps.h and form_uv).
template <class Real>
inline TangentFrame<Real> form_tangents(const TracedForm<Real>& form, int face, const Vec3<Real>& p) {
  const auto& [x, y, z] = form.axes;
  switch (form.kind) {
  case FormKind::ball: {
    const Vec3<Real> east{-p.z, 0, p.x}, unit = normalised(p);
    const Vec3<Real> north = Vec3<Real>{0, 1, 0} - unit * unit.y;
    return {east, north};
  }
  case FormKind::plane:
  case FormKind::rectangle:
    return {x, y};
  case FormKind::brick:
    if (face == 0) return {-z, y};
    if (face == 1) return {z, y};
    if (face == 2) return {x, -z};
    if (face == 3) return {x, z};
    if (face == 5) return {-x, y};
    return {x, y};
  case FormKind::cylinder: {
    if (face != 2) return {x, y};
    const Vec3<Real> local = in_frame(form, p);
    return {y * local.x - x * local.y, z};
  }
  }
  return {};
}

/// How the texture lies on the surface that a ray met; nothing where it has no texture coordinates.
template <class Real>
inline std::optional<TangentFrame<Real>> tangents_of(const Surface<Real>& surface,
                                                     const TracedGeometry<Real>& geometry) {
  const Primitive& primitive = geometry.primitives[surface.primitive];
  switch (primitive.kind) {
  case PrimitiveKind::sphere: {
    TracedForm<Real> ball;
    return form_tangents(ball, 0, surface.geometric_normal);
  }
  case PrimitiveKind::triangle: {
    const TracedTriangle<Real>& triangle = geometry.triangles[primitive.shape];
    if (!surface.has_uv || triangle.attributes < 0) return {};
    const auto& attributes = geometry.attributes[static_cast<std::size_t>(triangle.attributes)];
    return triangle_frame<Real>({triangle.a, triangle.b, triangle.c}, attributes.uvs);
  }
  case PrimitiveKind::solid: {
    const TracedSolid& solid = geometry.solids[primitive.shape];
    const TracedForm<Real>& form = geometry.forms[solid.first_form + detail_part(surface.detail)];
    return form_tangents(form, detail_face(surface.detail), surface.point - form.centre);
  }
  }
  return {};
}

}  // namespace ps
