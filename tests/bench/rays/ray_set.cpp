#include "bench/rays/ray_set.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "frame/viewport.h"

namespace ps::bench {
namespace {

/// In [0, 1). Not a standard distribution, whose numbers differ between libraries.
double uniform(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-32; }

}  // namespace

std::vector<BenchRay> primary_rays(const View& view) {
  const Viewport<float> viewport = make_viewport<float>(view, Settings{});
  const Camera& camera = view.camera;
  const Vec3f origin(camera.position), right(camera.right), up(camera.up);
  const Vec3f forward(camera.forward * camera.projection_plane_d);
  std::vector<BenchRay> rays;
  for (int row = 0; row < view.height; ++row)
    for (int column = 0; column < view.width; ++column) {
      const Vec2f v = viewport.at(column, row);
      rays.push_back({origin, right * v.x + up * v.y + forward, std::numeric_limits<float>::infinity()});
    }
  return rays;
}

SurfacePoints surface_points(const Mesh& mesh, std::span<const BenchRay> primary, const FindNearest& nearest) {
  std::vector<BenchHit> hits(primary.size());
  nearest(primary, hits);
  const double lift = 1e-4 * bounding_sphere(mesh).radius;
  SurfacePoints surface;
  for (std::size_t i = 0; i < primary.size(); ++i) {
    if (hits[i].triangle == no_hit) continue;
    const auto& corners = mesh.triangles[hits[i].triangle].position;
    const Vec3d a = mesh.positions[corners[0]];
    Vec3d normal = glm::normalize(cross(mesh.positions[corners[1]] - a, mesh.positions[corners[2]] - a));
    const Vec3d direction(primary[i].direction);
    if (dot(normal, direction) > 0) normal = -normal;
    const Vec3d point = Vec3d(primary[i].origin) + static_cast<double>(hits[i].t) * direction + lift * normal;
    surface.points.emplace_back(point);
    surface.normals.emplace_back(normal);
  }
  return surface;
}

std::vector<BenchRay> shadow_rays(const SurfacePoints& surface, const Vec3d& light) {
  std::vector<BenchRay> rays;
  for (const Vec3f& point : surface.points) rays.push_back({point, Vec3f(light) - point, 1});
  return rays;
}

std::vector<BenchRay> random_rays(const SurfacePoints& surface) {
  std::mt19937 random(20);
  std::vector<BenchRay> rays;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    // A point on the unit sphere around the tip of the normal gives the cosine-weighted direction.
    const double z = 2 * uniform(random) - 1, angle = 2 * std::numbers::pi * uniform(random);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    const Vec3d on_sphere{r * std::cos(angle), r * std::sin(angle), z};
    const Vec3d direction = Vec3d(surface.normals[i]) + 0.999 * on_sphere;
    rays.push_back({surface.points[i], Vec3f(glm::normalize(direction)), std::numeric_limits<float>::infinity()});
  }
  for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[random() % i]);
  return rays;
}

std::string compare_hits(std::span<const BenchHit> ours, std::span<const BenchHit> theirs, std::string& note) {
  std::size_t our_hits = 0, their_hits = 0, differing = 0, first = ours.size();
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const bool we = ours[i].triangle != no_hit, they = theirs[i].triangle != no_hit;
    our_hits += we;
    their_hits += they;
    if (we == they) continue;
    ++differing;
    first = std::min(first, i);
  }
  note = fmt::format("{} rays, {} hits, {} differ", ours.size(), our_hits, differing);
  if (static_cast<double>(differing) <= 1e-4 * static_cast<double>(ours.size()) && their_hits > 0) return "";
  return fmt::format("{} hits against {}, {} of {} rays differ, the first is ray {}", our_hits, their_hits, differing,
                     ours.size(), first);
}

}  // namespace ps::bench
