#pragma once
#include <cstdint>
#include <vector>

#include "scene/mesh.h"

namespace ps {

/// Gives the vertices of triangles that have no normals the normal of their smoothing group at that vertex: the mean of
/// the group's triangle normals there, weighted by the triangles' angles (Thuermer and Wuethrich 1998), so that it does
/// not depend on how a polygon was cut. `groups` holds one number for each triangle; 0 = none, which stays flat, as do
/// triangles with a vertex at which the mean is zero. New normals are of length 1.
void add_smooth_normals(Mesh& mesh, const std::vector<std::uint32_t>& groups);

}  // namespace ps
