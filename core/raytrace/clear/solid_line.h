#pragma once
#include <cmath>
#include <limits>
#include <utility>

#include "options/settings.h"
#include "raytrace/base/geometry.h"
#include "raytrace/clear/sphere_robust.h"

namespace ps {

/// The stretch of a line inside a convex form (CGFS ch. 5), with the face at each end; faces are numbered as in
/// scene/uv_maps.h, 0 for forms with only one. A flat form is met at `enter` alone.
template <class Real>
struct LineSpan {
  Real enter = 0, leave = 0;
  int enter_face = 0, leave_face = 0;
  bool empty = true;
};

/// The face on which a ray is known to start; -1 = none. The form's own surface is there at t = 0 by definition.
inline constexpr int no_face = -1;

template <class Real>
inline Real infinite() {
  return std::numeric_limits<Real>::infinity();
}

/// Components along the form's axes.
template <class Real>
inline Vec3<Real> in_frame(const TracedForm<Real>& form, const Vec3<Real>& v) {
  return {dot(form.axes[0], v), dot(form.axes[1], v), dot(form.axes[2], v)};
}

template <class Real>
inline LineSpan<Real> ball_line(const Vec3<Real>& origin, const Vec3<Real>& direction, Real a,
                                const TracedForm<Real>& ball, SphereTest test, int start) {
  const TracedSphere<Real> sphere{ball.centre, ball.half.x};
  SphereRoots<Real> roots;
  if (start != no_face)
    roots = sphere_from_surface(origin, direction, a, sphere);
  else if (test == SphereTest::robust)
    roots = sphere_robust(origin, direction, a, sphere);
  else
    roots = sphere_quadratic(origin, direction, a, sphere);
  return {roots.near, roots.far, 0, 0, !(roots.discriminant >= 0)};
}

/// The half space behind a plane.
template <class Real>
inline LineSpan<Real> plane_line(const Vec3<Real>& origin, const Vec3<Real>& direction, const TracedForm<Real>& plane,
                                 int start) {
  const Real height = dot(origin - plane.centre, plane.axes[2]);
  const Real rise = dot(direction, plane.axes[2]);
  const Real t = start != no_face ? Real(0) : -height / rise;
  if (rise < 0) return {t, infinite<Real>(), 0, 0, false};
  if (rise > 0) return {-infinite<Real>(), t, 0, 0, false};
  return {-infinite<Real>(), infinite<Real>(), 0, 0, start != no_face || height > 0};
}

template <class Real>
inline LineSpan<Real> rectangle_line(const Vec3<Real>& origin, const Vec3<Real>& direction,
                                     const TracedForm<Real>& rectangle, int start) {
  LineSpan<Real> span{0, infinite<Real>(), 0, 0, true};
  const Vec3<Real> from_corner = origin - rectangle.centre;
  const Real rise = dot(direction, rectangle.axes[2]);
  if (start != no_face || rise == 0) return span;
  span.enter = -dot(from_corner, rectangle.axes[2]) / rise;
  const Vec3<Real> point = from_corner + direction * span.enter;
  const Real u = dot(point, rectangle.axes[0]), v = dot(point, rectangle.axes[1]);
  span.empty = !(u >= 0 && u <= rectangle.half.x && v >= 0 && v <= rectangle.half.y);
  return span;
}

/// Cuts the span to the slab low <= x <= high along one axis, whose faces are `face` and `face + 1`.
template <class Real>
inline void cut_to_slab(LineSpan<Real>& span, Real x, Real dx, Real low, Real high, int face, int start) {
  if (dx == 0) {
    if (!(x >= low && x <= high) && start != face && start != face + 1) span.empty = true;
    return;
  }
  Real near = start == face ? Real(0) : (low - x) / dx;
  Real far = start == face + 1 ? Real(0) : (high - x) / dx;
  int near_face = face, far_face = face + 1;
  if (dx < 0) {
    std::swap(near, far);
    std::swap(near_face, far_face);
  }
  if (near > span.enter) {
    span.enter = near;
    span.enter_face = near_face;
  }
  if (far < span.leave) {
    span.leave = far;
    span.leave_face = far_face;
  }
}

template <class Real>
inline LineSpan<Real> brick_line(const Vec3<Real>& origin, const Vec3<Real>& direction, const TracedForm<Real>& brick,
                                 int start) {
  const Vec3<Real> o = in_frame(brick, origin - brick.centre), d = in_frame(brick, direction);
  LineSpan<Real> span{-infinite<Real>(), infinite<Real>(), 0, 0, false};
  for (int axis = 0; axis < 3; ++axis)
    cut_to_slab(span, o[axis], d[axis], -brick.half[axis], brick.half[axis], 2 * axis, start);
  span.empty = span.empty || !(span.enter <= span.leave);
  return span;
}

template <class Real>
inline LineSpan<Real> cylinder_line(const Vec3<Real>& origin, const Vec3<Real>& direction,
                                    const TracedForm<Real>& cylinder, int start) {
  const Vec3<Real> o = in_frame(cylinder, origin - cylinder.centre), d = in_frame(cylinder, direction);
  const Real radius = cylinder.half.x;
  LineSpan<Real> span{-infinite<Real>(), infinite<Real>(), 2, 2, false};
  const Real a = d.x * d.x + d.y * d.y;
  if (a > 0) {  // the sphere's robust quadratic, without the third axis
    const Real b = -(o.x * d.x + o.y * d.y);
    if (start == 2) {
      const Real other = 2 * b / a;
      span.enter = other < 0 ? other : Real(0);
      span.leave = other < 0 ? Real(0) : other;
    } else {
      const Real x = o.x + d.x * (b / a), y = o.y + d.y * (b / a);
      const Real discriminant = radius * radius - (x * x + y * y);
      if (!(discriminant >= 0)) return {};
      const double ox = static_cast<double>(o.x), oy = static_cast<double>(o.y), r = static_cast<double>(radius);
      const Real c = static_cast<Real>(ox * ox + oy * oy - r * r);
      const Real root = std::sqrt(a * discriminant);
      const Real q = b + (b < 0 ? -root : root);
      span.enter = b < 0 ? q / a : c / q;
      span.leave = b < 0 ? c / q : q / a;
      if (q == 0) span.enter = span.leave = 0;
    }
  } else if (start != 2 && !(o.x * o.x + o.y * o.y <= radius * radius)) {
    return {};
  }
  cut_to_slab(span, o.z, d.z, Real(0), cylinder.half.z, 0, start);
  span.empty = span.empty || !(span.enter <= span.leave);
  return span;
}

/// Where the line origin + t * direction runs inside the form. `a` = D.D.
template <class Real>
inline LineSpan<Real> form_line(const Vec3<Real>& origin, const Vec3<Real>& direction, Real a,
                                const TracedForm<Real>& form, SphereTest sphere_test, int start) {
  switch (form.kind) {
  case FormKind::ball:
    return ball_line(origin, direction, a, form, sphere_test, start);
  case FormKind::plane:
    return plane_line(origin, direction, form, start);
  case FormKind::rectangle:
    return rectangle_line(origin, direction, form, start);
  case FormKind::brick:
    return brick_line(origin, direction, form, start);
  case FormKind::cylinder:
    return cylinder_line(origin, direction, form, start);
  }
  return {};
}

/// The same for a part of a CSG tree, in its own space where it has one; t stays what it is.
template <class Real>
inline LineSpan<Real> part_line(const TracedGeometry<Real>& geometry, const TracedForm<Real>& form,
                                const Vec3<Real>& origin, const Vec3<Real>& direction, Real a, SphereTest sphere_test,
                                int start) {
  Vec3<Real> own_origin = origin, own_direction = direction;
  if (form.place >= 0) {
    const TracedPlace<Real>& place = geometry.places[static_cast<std::size_t>(form.place)];
    own_origin = place.point(origin);
    own_direction = place.to_part * direction;
    a = dot(own_direction, own_direction);
  }
  return form_line(own_origin, own_direction, a, form, sphere_test, start);
}

}  // namespace ps
