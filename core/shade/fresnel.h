#pragma once
#include <cmath>
#include <optional>

#include "math/unit.h"

namespace ps {

/// A boundary between two materials as a ray meets it.
template <class Real>
struct Refraction {
  Vec3<Real> direction{0};  ///< of the ray beyond, of the same length as the one that came
  Real cos_incident = 0, cos_refracted = 0;
};

/// Snell's law (CGFS ch. 5): from index n1 into n2. `direction` has any length, `normal` length 1 on either side.
/// nullopt in total internal reflection.
template <class Real>
inline std::optional<Refraction<Real>> refract(const Vec3<Real>& direction, const Vec3<Real>& normal, Real n1,
                                               Real n2) {
  const Real length = length_of(direction);
  const Vec3<Real> unit = unit_of(direction);
  const Real along = dot(unit, normal);
  const Vec3<Real> facing = along > 0 ? -normal : normal;
  const Real cos_incident = std::abs(along);
  const Real ratio = n1 / n2;
  const Real square = 1 - ratio * ratio * (1 - cos_incident * cos_incident);
  if (!(square >= 0)) return {};
  const Real cos_refracted = std::sqrt(square);
  if (n1 == n2) return Refraction<Real>{direction, cos_incident, cos_refracted};
  const Vec3<Real> beyond = unit * ratio + facing * (ratio * cos_incident - cos_refracted);
  return Refraction<Real>{beyond * length, cos_incident, cos_refracted};
}

/// The share of unpolarised light that a boundary of two dielectrics reflects (Fresnel's equations).
template <class Real>
inline Real fresnel_share(Real cos_incident, Real cos_refracted, Real n1, Real n2) {
  const Real across = (n1 * cos_incident - n2 * cos_refracted) / (n1 * cos_incident + n2 * cos_refracted);
  const Real along = (n1 * cos_refracted - n2 * cos_incident) / (n1 * cos_refracted + n2 * cos_incident);
  return (across * across + along * along) / 2;
}

}  // namespace ps
