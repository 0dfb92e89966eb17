#pragma once
#include "scene/mesh.h"

namespace ps {

struct DisplacedSphereOptions {
  int divisions = 129;      ///< of each edge of the cube that is blown up to the sphere; at least 1
  double amplitude = 0.05;  ///< of the bumps, as a share of the radius, which is 1; 0 gives a plain sphere
};

/// A sphere with bumps of several sizes: a closed surface without symmetry, of any size, for measuring. It has exactly
/// 12 * divisions^2 triangles (129 gives 199,692 and 289 gives 1,002,252), nearly equal in area, because the lattice is
/// that of a cube's surface with equal angles. Vertex normals are those of the smooth surface, unit length. The
/// front sides face outwards.
Mesh make_displaced_sphere(const DisplacedSphereOptions& options = {});

}  // namespace ps
