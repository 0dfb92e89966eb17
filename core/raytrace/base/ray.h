#pragma once
#include <array>
#include <cstdint>

#include "math/has_nan.h"

namespace ps {

inline constexpr std::uint32_t no_primitive = 0xffffffffu;

/// Points origin + t * direction with t_min < t < t_max. World space; the direction may have any length.
template <class Real>
struct Ray {
  Vec3<Real> origin{0, 0, 0};
  Vec3<Real> direction{0, 0, 1};
  Real t_min = 0;
  Real t_max = 0;
  /// The primitive on whose surface the origin is known to lie (self-hit = offset, exclusion), or no_primitive.
  std::uint32_t start = no_primitive;
  bool passes_transparent = false;  ///< shadow rays: transparent primitives are not in the way
  bool excludes_start = false;      ///< `start` is not tested at all (self-hit = exclusion)
  std::uint32_t start_detail = 0;   ///< Hit::detail of the place where it starts
};

/// May the ray be searched for? One of which a number is NaN or infinite meets nothing, and no tree is asked.
template <class Real>
inline bool is_searchable(const Ray<Real>& ray) {
  const Vec3<Real>&o = ray.origin, &d = ray.direction;
  const Real sum = (o.x + o.y + o.z) * Real(0) + (d.x + d.y + d.z) * Real(0);  // 0 unless one of them is
  return sum == 0 || (is_finite(o) && is_finite(d));
}

/// Hit::detail of a sphere where the ray comes from its inside.
inline constexpr std::uint32_t leaves_sphere = 1;

/// The nearest intersection found so far.
template <class Real>
struct Hit {
  std::uint32_t primitive = no_primitive;
  Real t = 0;
  std::array<Real, 3> weights{};  ///< barycentric; zeros on a sphere
  std::uint32_t detail = 0;  ///< solids: which face of which part (raytrace/clear/csg.h); spheres: leaves_sphere or 0
  bool found() const { return primitive != no_primitive; }
};

}  // namespace ps
