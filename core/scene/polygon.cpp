#include "scene/polygon.h"

#include <algorithm>
#include <cmath>

#include "scene/ear_clipper.h"

namespace ps {
namespace {

/// Newell's method: exact for flat polygons, fair for others. Loops of opposite facing may cancel; then the largest
/// triangle of the fan decides.
Vec3d newell_normal(const std::vector<Vec3d>& corners) {
  Vec3d sum{0, 0, 0}, largest{0, 0, 0};
  double total = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    // Relative to the first vertex, so that places far from the origin lose no digits.
    const Vec3d a = corners[i] - corners[0];
    const Vec3d b = corners[(i + 1) % corners.size()] - corners[0];
    const Vec3d part = cross(a, b);
    sum += part;
    total += std::sqrt(dot(part, part));
    if (dot(part, part) > dot(largest, largest)) largest = part;
  }
  constexpr double cancelled = 1e-9;
  return std::sqrt(dot(sum, sum)) > cancelled * total ? sum : largest;
}

/// The polygon as seen against its facing, so that it runs counter-clockwise.
std::vector<Vec2d> flattened(const std::vector<Vec3d>& corners) {
  const Vec3d normal = newell_normal(corners);
  int axis = 0;  // the one to leave out: that along which the normal is longest
  for (int other : {1, 2})
    if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
  const bool flip = normal[axis] < 0;
  const int u = (axis + (flip ? 2 : 1)) % 3;
  const int v = (axis + (flip ? 1 : 2)) % 3;
  std::vector<Vec2d> flat;
  flat.reserve(corners.size());
  for (const Vec3d& corner : corners) flat.emplace_back(corner[u] - corners[0][u], corner[v] - corners[0][v]);
  return flat;
}

/// Whether the fan around vertex 0 fills it: every vertex turns left, and every triangle of the fan does.
bool is_convex_fan(const std::vector<Vec2d>& flat) {
  const std::size_t count = flat.size();
  for (std::size_t i = 0; i < count; ++i)
    if (!(turn_of(flat[i], flat[(i + 1) % count], flat[(i + 2) % count]) >= 0)) return false;
  for (std::size_t i = 1; i + 1 < count; ++i)
    if (!(turn_of(flat[0], flat[i], flat[i + 1]) >= 0)) return false;
  return true;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec3d>& corners, std::int64_t& work) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  if (count < 3) return {};
  if (count > 3) {
    const std::vector<Vec2d> flat = flattened(corners);
    if (!is_convex_fan(flat)) return EarClipper(flat, work).run();
  }
  std::vector<std::array<std::uint32_t, 3>> fan;
  fan.reserve(count - 2);
  for (std::uint32_t i = 1; i + 1 < count; ++i) fan.push_back({0, i, i + 1});
  return fan;
}

}  // namespace ps
