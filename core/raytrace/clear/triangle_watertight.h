#pragma once
#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <type_traits>

#include "raytrace/base/geometry.h"
#include "raytrace/clear/triangle_result.h"

namespace ps {

/// What the watertight test needs to know about a ray: the axis along which it mostly runs, and the shear and scale
/// that turn it into the unit z axis.
template <class Real>
struct Shear {
  int kx = 0, ky = 1, kz = 2;
  Real x = 0, y = 0, z = 1;

  Shear() = default;
  explicit Shear(const Vec3<Real>& direction) {
    const Vec3<Real> size{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    if (direction[kz] < 0) std::swap(kx, ky);  // keeps the winding
    x = direction[kx] / direction[kz];
    y = direction[ky] / direction[kz];
    z = Real(1) / direction[kz];
  }
};

/// Bound on the rounding error of n operations, relative to the result (Higham): n u / (1 - n u).
template <class Real>
constexpr Real rounding_bound(int n) {
  constexpr Real u = std::numeric_limits<Real>::epsilon() / 2;
  return static_cast<Real>(n) * u / (1 - static_cast<Real>(n) * u);
}

/// Bound on the error of t of a sheared triangle (pbrt 6.8): x, y, z and edge are the largest sizes of the sheared
/// coordinates and of the edge functions.
template <class Real>
inline Real t_error_bound(Real x, Real y, Real z, Real edge, Real determinant) {
  const Real error_z = rounding_bound<Real>(3) * z;
  const Real error_x = rounding_bound<Real>(5) * (x + z);
  const Real error_y = rounding_bound<Real>(5) * (y + z);
  const Real error_edge = Real(2) * (rounding_bound<Real>(2) * x * y + error_y * x + error_x * y);
  return Real(3) * (rounding_bound<Real>(3) * edge * z + error_edge * z + error_z * edge) / std::abs(determinant);
}

enum class TriangleGuard { none, rounding_of_t };

/// Ray and triangle without cracks (Woop, Benthin, Wald, JCGT 2013). Both triangles at an edge compute its edge
/// function from the same numbers with the sign reversed, so one of them claims every ray; where an edge function is 0
/// in float, double decides. There is no epsilon. With `rounding_of_t`, t must also exceed its own error bound: for
/// rays that start on a neighbouring surface.
template <class Real>
inline TriangleResult<Real> triangle_watertight(const Vec3<Real>& origin, const Shear<Real>& shear,
                                                const TracedTriangle<Real>& triangle, TriangleGuard guard) {
  // By address: operator[] would decide anew for each number which axis is meant.
  const Real* const o = glm::value_ptr(origin);
  const Real ox = o[shear.kx], oy = o[shear.ky], oz = o[shear.kz];
  struct Sheared {
    Real x, y, far;  // far: along the ray, before the scale
  };
  const auto sheared = [&](const Vec3<Real>& corner) {
    const Real* const p = glm::value_ptr(corner);
    const Real far = p[shear.kz] - oz;
    return Sheared{(p[shear.kx] - ox) - shear.x * far, (p[shear.ky] - oy) - shear.y * far, far};
  };
  const auto [ax, ay, a_far] = sheared(triangle.a);
  const auto [bx, by, b_far] = sheared(triangle.b);
  const auto [cx, cy, c_far] = sheared(triangle.c);
  Real u = cx * by - cy * bx;
  Real v = ax * cy - ay * cx;
  Real w = bx * ay - by * ax;
  if constexpr (std::is_same_v<Real, float>) {
    if (u == 0 || v == 0 || w == 0) {
      const auto difference = [](float p, float q, float r, float s) {
        return static_cast<float>(static_cast<double>(p) * static_cast<double>(q) -
                                  static_cast<double>(r) * static_cast<double>(s));
      };
      u = difference(cx, by, cy, bx);
      v = difference(ax, cy, ay, cx);
      w = difference(bx, ay, by, ax);
    }
  }
  TriangleResult<Real> result;
  const Real determinant = u + v + w;
  if (!(determinant != 0)) {
    result.verdict = TriangleVerdict::parallel;
    return result;
  }
  const Real az = shear.z * a_far, bz = shear.z * b_far, cz = shear.z * c_far;
  result.weights = {u / determinant, v / determinant, w / determinant};
  result.t = (u * az + v * bz + w * cz) / determinant;
  const bool inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);  // false for NaN
  if (!inside) {
    result.corner = result.weights[0] < 0 ? 0 : result.weights[1] < 0 ? 1 : 2;
    return result;
  }
  result.verdict = TriangleVerdict::inside;
  if (guard == TriangleGuard::rounding_of_t) {
    const auto largest = [](Real p, Real q, Real r) { return std::max({std::abs(p), std::abs(q), std::abs(r)}); };
    const Real bound =
        t_error_bound(largest(ax, bx, cx), largest(ay, by, cy), largest(az, bz, cz), largest(u, v, w), determinant);
    if (!(result.t > bound)) result.verdict = TriangleVerdict::guarded;
  }
  return result;
}

}  // namespace ps
