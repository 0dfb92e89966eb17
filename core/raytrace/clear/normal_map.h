#pragma once
#include <cmath>
#include <numbers>
#include <optional>

#include "math/unit.h"
#include "raytrace/clear/surface_point.h"
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

/// The same with true lengths, so that dP/du and -dP/dv have the right proportion; the common factor of a ball's
/// radius is left out.
template <class Real>
inline TangentFrame<Real> form_relief_tangents(const TracedForm<Real>& form, int face, const Vec3<Real>& p) {
  constexpr Real pi = std::numbers::pi_v<Real>;
  TangentFrame<Real> frame = form_tangents(form, face, p);
  switch (form.kind) {
  case FormKind::ball: {  // east is as long as the circle of latitude is wide; both grow short towards the poles
    const Real north = length_of(frame.upwards);
    if (!(north > 0)) return {};
    return {frame.along_u * (2 * pi / length_of(p)), frame.upwards * (pi / north)};
  }
  case FormKind::plane:
    return frame;
  case FormKind::rectangle:
    return {frame.along_u * form.half.x, frame.upwards * form.half.y};
  case FormKind::brick: {  // each face is a cell of the cross of 4 by 3
    const auto half = [&](const Vec3<Real>& axis) {
      Real sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += std::abs(dot(axis, form.axes[k])) * form.half[static_cast<int>(k)];
      return sum;
    };
    return {frame.along_u * (8 * half(frame.along_u)), frame.upwards * (6 * half(frame.upwards))};
  }
  case FormKind::cylinder:
    if (face != 2) return {frame.along_u * form.half.x, frame.upwards * form.half.x};
    return {normalised(frame.along_u) * (2 * pi * form.half.x), frame.upwards * form.half.z};
  }
  return frame;
}

enum class TangentLengths { any, in_proportion };

/// How the texture lies on the surface that a ray met; nullopt where it has no texture coordinates.
template <class Real>
inline std::optional<TangentFrame<Real>> tangents_of(const SurfacePoint<Real>& surface,
                                                     const TracedGeometry<Real>& geometry,
                                                     TangentLengths lengths = TangentLengths::any) {
  const auto of_form = [&](const TracedForm<Real>& form, int face, const Vec3<Real>& p) {
    return lengths == TangentLengths::any ? form_tangents(form, face, p) : form_relief_tangents(form, face, p);
  };
  const Primitive primitive = primitive_of(geometry, surface.primitive);
  switch (primitive.kind) {
  case PrimitiveKind::sphere: {
    TracedForm<Real> ball;
    return of_form(ball, 0, surface.geometric_normal);
  }
  case PrimitiveKind::triangle: {
    TracedTriangle<Real> placed;
    const TracedTriangle<Real>& triangle = triangle_of(geometry, primitive, placed);
    if (!surface.has_uv || triangle.attributes < 0) return {};
    TriangleAttributes<Real> placed_ones;
    const TriangleAttributes<Real>& attributes = attributes_of(geometry, primitive, triangle, placed_ones);
    return triangle_frame<Real>({triangle.a, triangle.b, triangle.c}, attributes.uvs);
  }
  case PrimitiveKind::solid: {
    const TracedSolid& solid = geometry.solids[primitive.shape];
    const TracedForm<Real>& form = geometry.forms[solid.first_form + detail_part(surface.detail)];
    if (form.place < 0) return of_form(form, detail_face(surface.detail), surface.point - form.centre);
    const TracedPlace<Real>& place = geometry.places[static_cast<std::size_t>(form.place)];
    const TangentFrame<Real> own = of_form(form, detail_face(surface.detail), place.point(surface.point) - form.centre);
    return TangentFrame<Real>{place.to_world * own.along_u, place.to_world * own.upwards};
  }
  }
  return {};
}

/// The placing of the surface: that of its object, or of the part of a CSG object.
template <class Real>
inline Placing<Real> placing_at(const SurfacePoint<Real>& surface, const TraceInputs<Real>& inputs) {
  const TracedGeometry<Real>& geometry = *inputs.geometry;
  const Primitive primitive = primitive_of(geometry, surface.primitive);
  if (primitive.kind == PrimitiveKind::solid) {
    const TracedForm<Real>& form =
        geometry.forms[geometry.solids[primitive.shape].first_form + detail_part(surface.detail)];
    if (form.place >= 0) return placing_of<Real>(Mat3d(geometry.places[static_cast<std::size_t>(form.place)].to_world));
  }
  return inputs.placings[static_cast<std::size_t>(primitive.id.object)];
}

}  // namespace ps
