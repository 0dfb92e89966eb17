#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "accel/box.h"
#include "accel/slab.h"
#include "scene/object.h"

namespace ps {

/// The way of rays from the world into a model's space. Only tests against boxes use it: hits are decided in world
/// space. t stays the same on the way, since directions keep their lengths.
struct IntoModel {
  bool exists = false;  ///< false: the transform flattens the model, and there is no way back
  Mat3d matrix{1.0};    ///< inverse of rotation * scale
  Vec3d origin{0};      ///< where the model's origin is in the world
  Vec3d spread{0};      ///< sums of the absolute values of the matrix's rows
  Vec3d reach{0};       ///< the model's largest absolute coordinates, by axis
  double placed = 0;    ///< bound on the world coordinates of the model's vertices, and on their sums on the way there
  double residual = 0;  ///< how far a step of 1 to the model and back misses: the inverse's own error
};

/// `corners` holds all of the model's vertices.
inline IntoModel into_model(const Transform& transform, const Box<double>& corners) {
  IntoModel into;
  into.origin = transform.translation;
  const Mat3d back = glm::inverse(transform.rotation);
  const Mat3d unit = transform.rotation * back;
  constexpr double v = std::numeric_limits<double>::epsilon() / 2;
  for (int row = 0; row < 3; ++row) {
    double sum = 0;
    for (int column = 0; column < 3; ++column) {
      sum += std::abs(unit[column][row] - (row == column ? 1 : 0));
      for (int k = 0; k < 3; ++k) sum += 8 * v * std::abs(transform.rotation[k][row] * back[column][k]);
    }
    into.residual = std::max(into.residual, sum);
  }
  into.exists = into.residual < 1e-3 && !corners.empty();  // `rotation` is used as given: it may have no inverse
  for (int row = 0; row < 3; ++row) {
    into.exists = into.exists && std::isnormal(1 / transform.scale[row]);
    into.reach[row] = std::max(std::abs(corners.low[row]), std::abs(corners.high[row]));
    for (int column = 0; column < 3; ++column) {
      into.matrix[column][row] = back[column][row] / transform.scale[row];
      into.spread[row] += std::abs(into.matrix[column][row]);
    }
  }
  for (int row = 0; row < 3; ++row) {
    double sum = std::abs(transform.translation[row]);
    for (int column = 0; column < 3; ++column)
      sum += std::abs(transform.rotation[column][row] * transform.scale[column]) * into.reach[column];
    into.placed = std::max(into.placed, sum);
  }
  return into;
}

/// The ray in the space of the model's boxes; nullopt if no box can be rejected.
///
/// How far the boxes must be grown: let the ray pass within `pad` of a corner-to-corner placed triangle, on each axis
/// of the world (CandidateRay). With u the half ulp of Real and v that of double, sizes of coordinates at most `placed`
/// in the model and |o| at the ray's origin:
///   - the triangle's vertices in the world are those of the model within u placed (rounded to Real) + 16 v placed
///   (made
///     in double); the ray's origin and direction come back within (16 v + residual) (placed + |o|). Going back into
///     the model, a step of e along each axis of the world becomes at most spread * e;
///   - there, rounding origin and direction to Real, adding the pad, and the slab test's own three operations move the
///     ray by at most u (|o| + |o| + (|o| + reach) + 3 (|o| + reach)) against the planes of an axis.
/// Boxes themselves are rounded outwards. The sum is rounded up generously.
template <class Real>
std::optional<SlabRay<Real>> slabs_in_model(const IntoModel& into, const Vec3<Real>& origin,
                                            const Vec3<Real>& direction, Real pad, SlabForm form) {
  constexpr double u = static_cast<double>(std::numeric_limits<Real>::epsilon()) / 2;
  constexpr double v = std::numeric_limits<double>::epsilon() / 2;
  if (!into.exists) return {};
  const Vec3d from = into.matrix * (Vec3d(origin) - into.origin);
  const Vec3d along = into.matrix * Vec3d(direction);
  const double size = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
  if (!(size > 1e-30 && size < 1e30)) return {};  // would not survive the rounding to Real
  const Vec3<Real> start(from), run(along);
  if (form == SlabForm::naive) return SlabRay<Real>(start, run, Real(0), form);
  const double far = std::max({std::abs(static_cast<double>(origin.x)), std::abs(static_cast<double>(origin.y)),
                               std::abs(static_cast<double>(origin.z))});
  const double in_world =
      static_cast<double>(pad) + u * into.placed + (32 * v + 2 * into.residual) * (into.placed + far);
  Vec3<Real> pads;
  for (int axis = 0; axis < 3; ++axis)
    pads[axis] = static_cast<Real>((1 + 4 * u) * into.spread[axis] * in_world +
                                   8 * u * (std::abs(from[axis]) + into.reach[axis]));
  return SlabRay<Real>(start, run, pads, form);
}

}  // namespace ps
