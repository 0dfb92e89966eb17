#include "study/stability/ground_sphere_points.h"

#include <algorithm>
#include <cmath>

#include "raytrace/clear/sphere_robust.h"

namespace ps::stability {
namespace {

constexpr int picture_side = 600;

/// The robust form with all numbers of one precision: c is (|f| - r)(|f| + r).
template <class Real>
SphereRoots<Real> sphere_remainder(const Vec3<Real>& origin, const Vec3<Real>& direction, Real a,
                                   const TracedSphere<Real>& sphere) {
  const Vec3<Real> from_centre = origin - sphere.centre;
  return roots_of_remainder<Real>(from_centre, direction, a, sphere.radius, [&] {
    const Real distance = std::sqrt(dot(from_centre, from_centre));
    return (distance - sphere.radius) * (distance + sphere.radius);
  });
}

template <class Real>
SphereRoots<Real> roots_of(SphereForm form, const Vec3<Real>& origin, const Vec3<Real>& direction,
                           const TracedSphere<Real>& sphere) {
  const Real a = dot(direction, direction);
  return form == SphereForm::textbook ? sphere_quadratic<Real>(origin, direction, a, sphere)
                                      : sphere_remainder<Real>(origin, direction, a, sphere);
}

/// Calls visit(point) for each place where a ray of the camera meets the ground.
template <class Real, class Visit>
void for_each_point(const TracedSphere<Real>& ground, SphereForm form, Visit&& visit) {
  constexpr int middle = picture_side / 2;
  for (int row = 0; row < picture_side; ++row)
    for (int column = 0; column < picture_side; ++column) {
      const Vec3<Real> direction{static_cast<Real>(column - middle) / Real(picture_side),
                                 static_cast<Real>(middle - row) / Real(picture_side), Real(1)};
      const Vec3<Real> eye(0);
      const SphereRoots<Real> roots = roots_of(form, eye, direction, ground);
      if (roots.discriminant >= 0 && roots.near > 0) visit(eye + direction * roots.near);
    }
}

template <class Real>
TracedSphere<Real> ground_of(double radius) {
  return {Vec3<Real>(Vec3d(0, -1 - radius, 0)), static_cast<Real>(radius)};
}

template <class Real, class Error>
OffSurface off_surface(double radius, SphereForm form) {
  const TracedSphere<Real> ground = ground_of<Real>(radius);
  long double squares = 0, largest = 0;
  int points = 0;
  for_each_point(ground, form, [&](const Vec3<Real>& point) {
    Error distance_squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Error difference = static_cast<Error>(point[axis]) - static_cast<Error>(ground.centre[axis]);
      distance_squared += difference * difference;
    }
    const long double off = std::sqrt(distance_squared) - static_cast<Error>(ground.radius);
    squares += off * off;
    largest = std::max(largest, std::abs(off));
    ++points;
  });
  if (points == 0) return {};
  return {static_cast<double>(std::sqrt(squares / points)), static_cast<double>(largest)};
}

}  // namespace

OffSurface hit_off_surface(double radius, SphereForm form, Precision numbers, ErrorIn error_in,
                           const StabilityRun& run) {
  run.check();
  if (numbers == Precision::float32)
    return error_in == ErrorIn::same ? off_surface<float, float>(radius, form)
                                     : off_surface<float, long double>(radius, form);
  return error_in == ErrorIn::same ? off_surface<double, double>(radius, form)
                                   : off_surface<double, long double>(radius, form);
}

double false_shadow_by_remainder(float epsilon, const StabilityRun& run) {
  run.check();
  const TracedSphere<float> ground = ground_of<float>(5000);
  const Vec3f light(2, 1, 0);
  double lit = 0, wrong = 0;
  for_each_point(ground, SphereForm::remainder, [&](const Vec3f& point) {
    // A light sees all of a ball that turns towards it.
    const Vec3d exact(point), normal = exact - Vec3d(ground.centre);
    if (!(dot(normal, Vec3d(light) - exact) > 0)) return;
    ++lit;
    const auto roots = roots_of<float>(SphereForm::remainder, point, light - point, ground);
    const auto blocks = [&](float t) { return t > epsilon && t < 1; };
    wrong += roots.discriminant >= 0 && (blocks(roots.near) || blocks(roots.far)) ? 1 : 0;
  });
  return percent(wrong, lit);
}

}  // namespace ps::stability
