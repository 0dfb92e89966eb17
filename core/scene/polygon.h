#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace ps {

/// How many vertices may be looked at before what is left of a polygon becomes a fan: about a second of work. Who cuts
/// many polygons counts down one number for all of them.
inline constexpr std::int64_t most_polygon_work = 400'000'000;

/// What a polygon is cut into: vertices are indices into it (0, 1, 2, ...).
struct CutPolygon {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool crosses_itself = false;  ///< two of its edges cross between their vertices (not looked for beyond a limit)
};

/// Cuts a polygon in space into corners.size() - 2 triangles with the same facing. Convex polygons become a fan around
/// vertex 0, others lose one ear after the other; a polygon that is not flat is cut as it appears along its mean
/// normal. It may touch itself: loops that share a vertex, and holes reached by bridges, are filled to their outlines.
/// Where it crosses itself between vertices the triangles may overlap, as no vertex is made there, and so they may
/// where `work`, from which each vertex looked at is taken, is used up; their number stays.
CutPolygon triangulate_polygon(const std::vector<Vec3d>& corners, std::int64_t& work);

}  // namespace ps
