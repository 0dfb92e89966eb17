#pragma once
#include <cstdint>
#include <vector>

#include "raytrace/base/geometry.h"

namespace ps {

/// For each bounded primitive (bounded_primitive()) the first one in the very same place: itself, or an earlier
/// triangle with the same vertices in any order, or an earlier sphere or solid with the same box.
template <class Real>
std::vector<std::uint32_t> coincident_primitives(const TracedGeometry<Real>& geometry);

}  // namespace ps
