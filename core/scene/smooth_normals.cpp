#include "scene/smooth_normals.h"

#include <glm/geometric.hpp>
#include <unordered_map>

#include "math/portable.h"
#include "math/unit.h"

namespace ps {
namespace {

/// The triangle's normal times its angle at vertex i; zero where the triangle has no area.
Vec3d weighted_normal(const Mesh& mesh, const MeshTriangle& triangle, std::size_t i) {
  const Vec3d& tip = mesh.positions[triangle.position[i]];
  Vec3d a = mesh.positions[triangle.position[(i + 1) % 3]] - tip;
  Vec3d b = mesh.positions[triangle.position[(i + 2) % 3]] - tip;
  if (!(largest_component(a) > 0 && largest_component(b) > 0)) return Vec3d(0);
  a = unit_of(a);
  b = unit_of(b);
  const Vec3d normal = cross(a, b);
  const double sine = glm::length(normal);
  if (!(sine > 0)) return Vec3d(0);
  return normal * (portable::atan2(sine, dot(a, b)) / sine);
}

}  // namespace

void add_smooth_normals(Mesh& mesh, const std::vector<std::uint32_t>& groups) {
  const std::size_t own_normals = mesh.normals.size();
  const auto is_smooth = [&](std::size_t i) { return groups[i] > 0 && mesh.triangles[i].normal[0] < 0; };
  std::unordered_map<std::uint64_t, std::int32_t> normal_of;  // by group and vertex
  std::vector<std::array<std::int32_t, 3>> chosen(mesh.triangles.size(), {-1, -1, -1});
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!is_smooth(i)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t key = std::uint64_t{groups[i]} << 32 | mesh.triangles[i].position[k];
      const auto [entry, is_new] = normal_of.try_emplace(key, static_cast<std::int32_t>(mesh.normals.size()));
      if (is_new) mesh.normals.emplace_back(0);
      mesh.normals[static_cast<std::size_t>(entry->second)] += weighted_normal(mesh, mesh.triangles[i], k);
      chosen[i][k] = entry->second;
    }
  }
  std::vector<char> is_zero(mesh.normals.size(), 0);
  for (std::size_t n = own_normals; n < mesh.normals.size(); ++n) {
    const double length = glm::length(mesh.normals[n]);
    constexpr double cancelled = 1e-12;  // faces back to back leave rounding errors
    is_zero[n] = length > cancelled ? 0 : 1;
    mesh.normals[n] = is_zero[n] != 0 ? Vec3d(0) : mesh.normals[n] / length;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!is_smooth(i)) continue;
    bool whole = true;
    for (const std::int32_t n : chosen[i]) whole = whole && is_zero[static_cast<std::size_t>(n)] == 0;
    if (whole) mesh.triangles[i].normal = chosen[i];
  }
}

}  // namespace ps
