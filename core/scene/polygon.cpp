#include "scene/polygon.h"

#include <cmath>

namespace ps {
namespace {

/// The polygon as seen against its mean normal (Newell's method: exact for flat polygons, fair for others), so that it
/// runs counter-clockwise.
std::vector<Vec2d> flattened(const std::vector<Vec3d>& corners) {
  Vec3d normal{0, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    // Relative to the first vertex, so that places far from the origin lose no digits.
    const Vec3d a = corners[i] - corners[0];
    const Vec3d b = corners[(i + 1) % corners.size()] - corners[0];
    normal += cross(a, b);
  }
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

double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool inside(const Vec2d& p, const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

bool is_ear(const std::vector<Vec2d>& flat, const std::vector<std::uint32_t>& left, std::size_t before, std::size_t tip,
            std::size_t after) {
  const Vec2d& a = flat[left[before]];
  const Vec2d& b = flat[left[tip]];
  const Vec2d& c = flat[left[after]];
  if (!(turn(a, b, c) > 0)) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (i == before || i == tip || i == after) continue;
    const Vec2d& p = flat[left[i]];
    if (p != a && p != b && p != c && inside(p, a, b, c)) return false;
  }
  return true;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(const std::vector<Vec3d>& corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto count = static_cast<std::uint32_t>(corners.size());
  if (count < 3) return triangles;
  std::vector<std::uint32_t> left(count);
  for (std::uint32_t i = 0; i < count; ++i) left[i] = i;
  if (count > 3) {
    const std::vector<Vec2d> flat = flattened(corners);
    bool convex = true;
    for (std::uint32_t i = 0; i < count; ++i)
      convex = convex && turn(flat[i], flat[(i + 1) % count], flat[(i + 2) % count]) >= 0;
    // A simple polygon has an ear in every round; one that crosses itself may not, and what is left becomes a fan. The
    // number of attempts is bounded, since each looks at all vertices.
    std::size_t attempts = 30 * left.size();
    for (std::size_t tip = 0, failures = 0; !convex && left.size() > 3 && failures < left.size() && attempts > 0;) {
      --attempts;
      const std::size_t before = (tip + left.size() - 1) % left.size();
      const std::size_t after = (tip + 1) % left.size();
      if (is_ear(flat, left, before, tip, after)) {
        triangles.push_back({left[before], left[tip], left[after]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(tip));
        failures = 0;
      } else {
        ++tip;
        ++failures;
      }
      tip %= left.size();
    }
  }
  for (std::size_t i = 1; i + 1 < left.size(); ++i) triangles.push_back({left[0], left[i], left[i + 1]});
  return triangles;
}

}  // namespace ps
