#pragma once
#include <array>
#include <vector>

#include "scene/mesh.h"

namespace ps {

/// A bicubic Bezier patch: control point [4 * row + column]. u runs along the columns, v along the rows, both in
/// [0, 1]. The front is the side to which cross(d/du, d/dv) points.
struct BezierPatch {
  std::array<Vec3d, 16> control;
};

/// A parameter as step / steps, so that walking an edge from its other end gives the same numbers, bit for bit.
struct PatchParameter {
  int step = 0;
  int steps = 1;
};

/// The point of the patch. Two patches whose edges have the same control points, in either order, give equal points on
/// that edge, bit for bit.
Vec3d patch_point(const BezierPatch& patch, PatchParameter u, PatchParameter v);

/// The unit normal. Where an edge of the patch is a single point, the normal just beside it.
Vec3d patch_normal(const BezierPatch& patch, PatchParameter u, PatchParameter v);

/// Tessellates each patch into divisions x divisions quads of two triangles each; triangles without area (beside an
/// edge that is a single point) are left out. Equal positions share an index, so seams are closed. Normals are those of
/// the patch; (u, v) become texture coordinates.
Mesh tessellate(const std::vector<BezierPatch>& patches, int divisions);

}  // namespace ps
