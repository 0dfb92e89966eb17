#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace ps {

/// Cuts a polygon in space into corners.size() - 2 triangles with the same facing. Vertices are indices into the
/// polygon (0, 1, 2, ...). Convex polygons become a fan around vertex 0, others lose one ear after the other; a polygon
/// that is not flat is cut as it appears along its mean normal. Where a polygon crosses itself the triangles overlap,
/// but their number stays.
std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec3d>& corners);

}  // namespace ps
