#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "math/vec.h"

namespace ps::raster {

/// The plane of a triangle in camera space, in which depth-value = ray-plane looks up the depth of each sample (OCT,
/// "Rasterization with Depth Buffer"). It is made from the vertices before they are rounded to sub-pixels.
template <class Real>
struct DepthPlane {
  Vec3<Real> normal{0, 0, 0};  ///< of any length
  Real offset = 0;             ///< dot(normal, P) for each point P of the plane
  /// The z between which the drawn piece of the triangle lies. Where rounding of vertices lets a sample in whose ray
  /// passes the triangle by, or a ray runs along the plane, the intersection is far off or nowhere.
  Real nearest = 0, farthest = 0;

  /// z where the ray from the eye through (x, y, 1) meets the plane.
  Real along_eye_ray(Real x, Real y) const { return in_piece(offset / (normal.x * x + normal.y * y + normal.z)); }
  /// z where the ray from (x, y, 0) along (0, 0, 1) meets the plane: that of an orthographic picture.
  Real along_parallel_ray(Real x, Real y) const { return in_piece((offset - normal.x * x - normal.y * y) / normal.z); }

 private:
  /// NaN, which no comparison holds for, becomes the nearest z.
  Real in_piece(Real z) const { return !(z >= nearest) ? nearest : z > farthest ? farthest : z; }
};

/// The edge divided by a power of two, which loses nothing, so that its largest coordinate lies between 1/2 and 1:
/// products of edges then neither overflow nor vanish.
template <class Real>
Vec3<Real> scaled_edge(const Vec3<Real>& edge) {
  int exponent = 0;
  std::frexp(std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)}), &exponent);
  return {std::ldexp(edge.x, -exponent), std::ldexp(edge.y, -exponent), std::ldexp(edge.z, -exponent)};
}

/// Of the triangle with these vertices (camera space), where `z` are those of the piece that is drawn.
template <class Real>
DepthPlane<Real> make_depth_plane(const std::array<Vec3<Real>, 3>& corners, const std::array<Real, 3>& z) {
  DepthPlane<Real> plane;
  plane.normal = cross(scaled_edge(corners[1] - corners[0]), scaled_edge(corners[2] - corners[0]));
  plane.offset = dot(plane.normal, corners[0]);
  plane.nearest = std::min({z[0], z[1], z[2]});
  plane.farthest = std::max({z[0], z[1], z[2]});
  return plane;
}

}  // namespace ps::raster
