#include "hardware/near_triangles.h"

namespace ps::hardware {
namespace {

constexpr double margin = 1;  // pixels: lines and points are one wide, and drivers round positions to a fraction of one

/// Of each triangle: is there no side that all its vertices lie beyond? Those are bits.
std::vector<bool> near_ones(const std::vector<std::uint8_t>& beyond, const std::vector<MeshTriangle>& triangles) {
  std::vector<bool> near;
  near.reserve(triangles.size());
  for (const MeshTriangle& triangle : triangles) {
    const auto& p = triangle.position;
    near.push_back((beyond[p[0]] & beyond[p[1]] & beyond[p[2]]) == 0);
  }
  return near;
}

}  // namespace

NearTest::NearTest(const PicturePlan& plan, const TileRect& pixels)
    : plan_(plan), left_(pixels.x0 - margin), right_(pixels.x1 + margin), top_(pixels.y0 - margin),
      bottom_(pixels.y1 + margin) {}

// Sides of the neighbourhood, and of the plane through the eye, that a point lies beyond. The comparisons are between
// products with w, so they hold for points behind the eye, too.
std::uint8_t NearTest::beyond(const Vec3d& world) const {
  const Vec2d scale = plan_.projection.scale, centre = shifted_centre(plan_);
  const Vec3d camera = camera_position(plan_, world);
  const double w = plan_.perspective() ? camera.z : 1;
  const double x = camera.x * scale.x + centre.x * w, y = centre.y * w - camera.y * scale.y;
  return static_cast<std::uint8_t>((x < left_ * w) | (x > right_ * w) << 1 | (y < top_ * w) << 2 |
                                   (y > bottom_ * w) << 3 | !(w > 0) << 4);
}

std::vector<bool> NearTest::of_object(std::size_t object) const {
  const raster::DrawObject& draw = plan_.objects[object];
  std::vector<std::uint8_t> beyond_of;
  beyond_of.reserve(draw.mesh->positions.size());
  for (const Vec3d& position : draw.mesh->positions) beyond_of.push_back(beyond(draw.world(position)));
  return near_ones(beyond_of, draw.mesh->triangles);
}

std::vector<bool> NearTest::of_volume(const raster::ShadowVolume& volume) const {
  std::vector<std::uint8_t> beyond_of;
  beyond_of.reserve(volume.surface->positions.size());
  for (const Vec3d& position : volume.surface->positions) beyond_of.push_back(beyond(position));
  return near_ones(beyond_of, volume.surface->triangles);
}

}  // namespace ps::hardware
