#include "hardware/near_triangles.h"

namespace ps::hardware {
namespace {

constexpr double margin = 1;  // pixels: lines and points are one wide, and drivers round positions to a fraction of one

/// Sides of the neighbourhood, or of the plane through the eye, that a vertex lies beyond, as bits.
using Beyond = std::uint8_t;

}  // namespace

NearTest::NearTest(const PicturePlan& plan, Vec2i pixel)
    : plan_(plan), left_(pixel.x - margin), right_(pixel.x + 1 + margin), top_(pixel.y - margin),
      bottom_(pixel.y + 1 + margin) {}

// A triangle all of whose vertices lie beyond the same side is beyond it whole. The comparisons are between products
// with w, so they hold for vertices behind the eye, too.
std::vector<bool> NearTest::of_object(std::size_t object) const {
  const raster::DrawObject& draw = plan_.objects[object];
  const Vec2d scale = plan_.projection.scale, centre = shifted_centre(plan_);
  std::vector<Beyond> beyond;
  beyond.reserve(draw.mesh->positions.size());
  for (const Vec3d& position : draw.mesh->positions) {
    const Vec3d camera = camera_position(plan_, draw.world(position));
    const double w = plan_.perspective() ? camera.z : 1;
    const double x = camera.x * scale.x + centre.x * w, y = centre.y * w - camera.y * scale.y;
    beyond.push_back(static_cast<Beyond>((x < left_ * w) | (x > right_ * w) << 1 | (y < top_ * w) << 2 |
                                         (y > bottom_ * w) << 3 | !(w > 0) << 4));
  }
  std::vector<bool> near;
  near.reserve(draw.mesh->triangles.size());
  for (const MeshTriangle& triangle : draw.mesh->triangles) {
    const auto& p = triangle.position;
    near.push_back((beyond[p[0]] & beyond[p[1]] & beyond[p[2]]) == 0);
  }
  return near;
}

}  // namespace ps::hardware
