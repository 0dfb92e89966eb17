#pragma once
#include "scene/mesh.h"

namespace ps {

struct UvSphereOptions {
  int slices = 64;  ///< around the y axis, at least 3
  int stacks = 32;  ///< from pole to pole, at least 2
};

/// A sphere of radius 1 cut along meridians and parallels, poles at y = 1 and -1: 2 * slices * (stacks - 1) triangles.
/// Vertex normals are the positions. u runs once around with increasing angle from +x towards -z, v from 0 at y = 1 to
/// 1 at y = -1; at a pole u is the mean of its triangle's other two. The front sides face outwards.
Mesh make_uv_sphere(const UvSphereOptions& options = {});

}  // namespace ps
