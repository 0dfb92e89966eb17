#pragma once
#include "scene/mesh.h"

namespace ps {

struct TorusKnotOptions {
  int turns_around_axis = 2;  ///< p: times around the z axis; without a common divisor with q
  int turns_around_tube = 3;  ///< q: times around the torus's own circle
  double major_radius = 1;    ///< of the torus on which the knot's centre line lies
  double minor_radius = 0.45;
  double tube_radius = 0.18;
  int segments = 1000;  ///< along the knot, at least 3
  int sides = 100;      ///< around the tube, at least 3
};

/// A tube around the (p, q) torus knot: a closed surface that hides much of itself, with 2 * segments * sides
/// triangles (200,000 by default). Vertex normals point straight away from the centre line, unit length. u runs along
/// the knot, v around the tube. The front sides face outwards.
Mesh make_torus_knot(const TorusKnotOptions& options = {});

/// The knot's centre line at t in [0, 2 pi].
Vec3d torus_knot_line(const TorusKnotOptions& options, double t);

}  // namespace ps
