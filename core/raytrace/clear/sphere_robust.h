#pragma once
#include "raytrace/clear/sphere_quadratic.h"

namespace ps {

/// The discriminant over a from the vector that remains when the centre is projected onto the line (Haines, Guenther,
/// Akenine-Moeller, Ray Tracing Gems ch. 7). `t_nearest` is the ray parameter of the point next to the centre.
template <class Real>
inline Real remainder_discriminant(const Vec3<Real>& from_centre, const Vec3<Real>& direction, Real t_nearest,
                                   Real radius) {
  const Vec3<Real> remainder = from_centre + direction * t_nearest;
  return radius * radius - dot(remainder, remainder);
}

/// Roots from the remainder's discriminant as q = b + sign(b) sqrt(a disc), so that nothing of like size is subtracted.
/// The power of the origin, c, is the one place where that cannot be avoided: `power` returns it, and is asked only
/// where the line meets the sphere.
template <class Real, class Power>
inline SphereRoots<Real> roots_of_remainder(const Vec3<Real>& from_centre, const Vec3<Real>& direction, Real a,
                                            Real radius, Power&& power) {
  const Real b = -dot(from_centre, direction);
  SphereRoots<Real> roots;
  roots.discriminant = remainder_discriminant(from_centre, direction, b / a, radius);
  if (!(roots.discriminant >= 0)) return roots;
  const Real c = power();
  const Real root = std::sqrt(a * roots.discriminant);
  const Real q = b + (b < 0 ? -root : root);
  const Real with_c = c / q;
  const Real with_a = q / a;
  roots.near = b < 0 ? with_a : with_c;
  roots.far = b < 0 ? with_c : with_a;
  return roots;
}

/// Ray and sphere without cancellation (Haines, Guenther, Akenine-Moeller, Ray Tracing Gems ch. 7). c alone is computed
/// in double, since for the book's ground (radius 5000) float leaves it 4 digits. `a` = D.D.
template <class Real>
inline SphereRoots<Real> sphere_robust(const Vec3<Real>& origin, const Vec3<Real>& direction, Real a,
                                       const TracedSphere<Real>& sphere) {
  return roots_of_remainder<Real>(origin - sphere.centre, direction, a, sphere.radius, [&] {
    const Vec3d exact_from_centre = Vec3d(origin) - Vec3d(sphere.centre);
    const double radius = static_cast<double>(sphere.radius);
    return static_cast<Real>(dot(exact_from_centre, exact_from_centre) - radius * radius);
  });
}

/// The other root for a ray that starts on the sphere: one root is 0 by definition, so c = 0 and the roots are 0 and
/// -2 f.D / a. Nothing has to guard against the surface meeting itself.
template <class Real>
inline SphereRoots<Real> sphere_from_surface(const Vec3<Real>& origin, const Vec3<Real>& direction, Real a,
                                             const TracedSphere<Real>& sphere) {
  const Real b = -dot(origin - sphere.centre, direction);
  const Real other = Real(2) * b / a;
  return {b * b / a, other < 0 ? other : Real(0), other < 0 ? Real(0) : other};
}

}  // namespace ps
