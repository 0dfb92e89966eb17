#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "raytrace/base/geometry.h"
#include "raytrace/base/trace_inputs.h"

namespace ps {

/// Finds the bodies in which eye rays may begin: those of a transparent material that have an inside, with a box that
/// holds a point up to `reach` from the eye. Empty for nearly every picture, so that eye rays ask nothing further.
template <class Real>
std::vector<EyeBody> eye_bodies(const Scene& scene, const TracedGeometry<Real>& geometry, double reach,
                                const Vec3d& eye);

}  // namespace ps
