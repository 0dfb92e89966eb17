#pragma once
#include <cmath>

#include "raytrace/base/geometry.h"
#include "raytrace/base/ray.h"

namespace ps {

/// Where a line meets a sphere. Without real roots near and far are NaN.
template <class Real>
struct SphereRoots {
  Real discriminant = 0;  ///< negative: no real root; its scale depends on the method
  Real near = std::numeric_limits<Real>::quiet_NaN();
  Real far = std::numeric_limits<Real>::quiet_NaN();
};

/// The textbook solution of the quadratic equation, in the order of CGFS ch. 2. Loses all digits in float once the
/// sphere is some 4000 radii away. `a` = D.D.
template <class Real>
inline SphereRoots<Real> sphere_quadratic(const Vec3<Real>& origin, const Vec3<Real>& direction, Real a,
                                          const TracedSphere<Real>& sphere) {
  const Vec3<Real> from_centre = origin - sphere.centre;
  const Real b = Real(2) * dot(from_centre, direction);
  const Real c = dot(from_centre, from_centre) - sphere.radius * sphere.radius;
  SphereRoots<Real> roots;
  roots.discriminant = b * b - Real(4) * a * c;
  if (!(roots.discriminant >= 0)) return roots;
  const Real root = std::sqrt(roots.discriminant);
  roots.far = (-b + root) / (Real(2) * a);
  roots.near = (-b - root) / (Real(2) * a);
  return roots;
}

}  // namespace ps
