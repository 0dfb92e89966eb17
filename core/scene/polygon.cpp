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

/// An edge from left to right.
struct FlatEdge {
  Vec2d left, right;
};

/// Whether they cross at a point that is not an end of either. Rounding does not decide below `no_area`.
bool cross_between(const FlatEdge& a, const FlatEdge& b, double no_area) {
  const auto parts = [&](const FlatEdge& edge, const FlatEdge& other) {
    const double from = turn_of(edge.left, edge.right, other.left), to = turn_of(edge.left, edge.right, other.right);
    return std::min(from, to) < -no_area && std::max(from, to) > no_area;
  };
  return parts(a, b) && parts(b, a);
}

/// Goes over the edges from left to right. Of large polygons in which most edges lie over each other it looks at a
/// part.
bool crosses_itself(const std::vector<Vec2d>& flat) {
  std::size_t pairs_left = 64 * flat.size();
  std::vector<FlatEdge> edges;
  edges.reserve(flat.size());
  double size = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Vec2d &a = flat[i], &b = flat[(i + 1) % flat.size()];
    edges.push_back(a.x <= b.x ? FlatEdge{a, b} : FlatEdge{b, a});
    size = std::max({size, std::abs(a.x), std::abs(a.y)});
  }
  std::sort(edges.begin(), edges.end(), [](const FlatEdge& a, const FlatEdge& b) { return a.left.x < b.left.x; });
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = i + 1; k < edges.size() && edges[k].left.x < edges[i].right.x && pairs_left > 0;
         ++k, --pairs_left)
      if (cross_between(edges[i], edges[k], 1e-12 * size * size)) return true;
  return false;
}

}  // namespace

CutPolygon triangulate_polygon(const std::vector<Vec3d>& corners, std::int64_t& work) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  CutPolygon cut;
  if (count < 3) return cut;
  if (count > 3) {
    const std::vector<Vec2d> flat = flattened(corners);
    if (!is_convex_fan(flat)) {
      cut.triangles = EarClipper(flat, work).run();
      cut.crosses_itself = crosses_itself(flat);
      return cut;
    }
  }
  cut.triangles.reserve(count - 2);
  for (std::uint32_t i = 1; i + 1 < count; ++i) cut.triangles.push_back({0, i, i + 1});
  return cut;
}

}  // namespace ps
