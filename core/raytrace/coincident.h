#pragma once
#include <cstdint>
#include <vector>

#include "raytrace/geometry.h"

namespace ps {

/// For each primitive that has an end (bounded_primitive) the first one in the very same place: itself, or an earlier
/// triangle with the same corners in any order, or an earlier sphere or solid with the same box.
template <class Real>
std::vector<std::uint32_t> coincident_primitives(const TracedGeometry<Real>& geometry);

}  // namespace ps
