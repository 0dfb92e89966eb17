#pragma once
#include "raster/clear/coverage/input.h"

namespace ps::raster {

/// A point or a direction in canvas units, with the canvas as the plane z = 1.
struct CanvasPoint {
  std::int64_t x = 0, y = 0, z = 0;
};

/// The ray of a sample. The eye is moved to (0, 0, 0), above the picture's corner: a shear, which changes no volume.
/// Orthographic rays start at their sample and are parallel.
struct SampleRay {
  CanvasPoint origin, direction;
};

inline SampleRay sample_ray(const CoverageInput& input, int column, int row) {
  const std::int64_t unit = fixed_unit(input.grid.subpixel_bits);
  const FixedPoint offset = sample_offset(input.grid);
  const std::int64_t x = column * unit + offset.x, y = row * unit + offset.y;
  if (input.projection == Projection::perspective) return {{0, 0, 0}, {x, y, 1}};
  return {{x, y, 0}, {0, 0, 1}};
}

/// Six times the volume of the tetrahedron that the ray spans with a line from a to b; its sign is the side of the line
/// on which the ray passes.
inline std::int64_t ray_side(const SampleRay& ray, const FixedPoint& a, const FixedPoint& b) {
  const CanvasPoint p{a.x - ray.origin.x, a.y - ray.origin.y, 1}, q{b.x - ray.origin.x, b.y - ray.origin.y, 1};
  const CanvasPoint across{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  return ray.direction.x * across.x + ray.direction.y * across.y + ray.direction.z * across.z;
}

/// The three sides, positive where the ray passes inside. They equal the edge functions' values.
inline std::array<std::int64_t, 3> ray_sides(const CoverageInput& input, int column, int row) {
  const SampleRay ray = sample_ray(input, column, row);
  const std::int64_t sign = doubled_area(input.corners) > 0 ? 1 : -1;
  std::array<std::int64_t, 3> sides;
  for (std::size_t i = 0; i < 3; ++i)
    sides[i] = sign * ray_side(ray, input.corners[(i + 1) % 3], input.corners[(i + 2) % 3]);
  return sides;
}

/// One ray against the triangle for each sample of the box (CGPP 15.6.1; with the triangle's own box 15.6.2).
template <class Sink>
void walk_rays(const CoverageInput& input, const TileRect& box, Sink& sink) {
  sink.test_all(box);
  for (int row = box.y0; row < box.y1; ++row)
    for (int column = box.x0; column < box.x1; ++column) {
      const auto sides = ray_sides(input, column, row);
      if (input.edges.inside(sides)) sink.cover(column, row, sides);
    }
}

}  // namespace ps::raster
