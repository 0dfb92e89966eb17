#pragma once
#include <vector>

#include "scene/mesh.h"
#include "scene/patch.h"

namespace ps {

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

/// How strongly the surface bends away from its tangent plane at (u, v): the parts of the second derivatives along the
/// unit normal, in the patch's own units.
struct PatchBend {
  Vec3d point{0, 0, 0};
  double uu = 0, uv = 0, vv = 0;
};
PatchBend patch_bend(const BezierPatch& patch, PatchParameter u, PatchParameter v);

/// Tessellates each patch into divisions x divisions quads of two triangles each; triangles without area (beside an
/// edge that is a single point) are left out. Equal positions share an index, so seams are closed. Normals are those of
/// the patch; (u, v) become texture coordinates.
Mesh tessellate(const std::vector<BezierPatch>& patches, int divisions);

}  // namespace ps
