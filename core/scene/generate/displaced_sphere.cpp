#include "scene/generate/displaced_sphere.h"

#include <array>
#include <numbers>
#include <unordered_map>

#include "base/check.h"
#include "math/portable.h"
#include "math/unit.h"

namespace ps {
namespace {

/// One plane wave of the relief: weight * sin(dot(wave, direction) + phase).
struct Wave {
  double weight;
  Vec3d wave;
  double phase;
};

constexpr int wave_count = 6;
const std::array<Wave, wave_count> relief_waves{{{0.34, {3.1, -1.7, 2.3}, 0.4},
                                                 {0.24, {-5.3, 4.1, 6.7}, 1.9},
                                                 {0.17, {11.9, 8.3, -7.1}, 5.2},
                                                 {0.12, {-9.7, 21.3, 17.9}, 2.6},
                                                 {0.08, {37.1, -29.3, 31.7}, 0.9},
                                                 {0.05, {-61.3, 53.9, 47.3}, 3.8}}};

/// Radius in a unit direction, with its gradient in space.
struct Radius {
  double value;
  Vec3d gradient;
};

Radius radius_in(const Vec3d& direction, double amplitude) {
  Radius radius{1, {0, 0, 0}};
  for (const Wave& wave : relief_waves) {
    const double angle = dot(wave.wave, direction) + wave.phase;
    radius.value += amplitude * wave.weight * portable::sin(angle);
    radius.gradient += amplitude * wave.weight * portable::cos(angle) * wave.wave;
  }
  return radius;
}

/// Adds one vertex for each lattice point of the cube's surface, however many faces ask for it.
class Lattice {
 public:
  Lattice(Mesh& mesh, const DisplacedSphereOptions& options) : mesh_(mesh), options_(options) {}

  std::uint32_t vertex(const glm::ivec3& point) {
    const auto n = static_cast<std::uint64_t>(options_.divisions) + 1;
    const std::uint64_t key = (static_cast<std::uint64_t>(point.x) * n + static_cast<std::uint64_t>(point.y)) * n +
                              static_cast<std::uint64_t>(point.z);
    const auto [place, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) add(point);
    return place->second;
  }

 private:
  double warp(int step) const { return portable::tan((2.0 * step / options_.divisions - 1) * (std::numbers::pi / 4)); }

  void add(const glm::ivec3& point) {
    const Vec3d on_cube{warp(point.x), warp(point.y), warp(point.z)};
    const Vec3d direction = unit_of(on_cube);
    const Radius radius = radius_in(direction, options_.amplitude);
    mesh_.positions.push_back(radius.value * direction);
    // The surface is where |p| = radius(p / |p|); the normal is the gradient of the difference.
    const Vec3d along = radius.gradient - dot(radius.gradient, direction) * direction;
    const Vec3d normal = direction - along / radius.value;
    mesh_.normals.push_back(unit_of(normal));
  }

  Mesh& mesh_;
  const DisplacedSphereOptions& options_;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;
};

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  MeshTriangle triangle;
  triangle.position = {a, b, c};
  triangle.normal = {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)};
  mesh.triangles.push_back(triangle);
}

}  // namespace

Mesh make_displaced_sphere(const DisplacedSphereOptions& options) {
  PS_ASSERT(options.divisions >= 1, "the cube needs at least one division");
  const int n = options.divisions;
  Mesh mesh;
  mesh.name = "displaced sphere";
  mesh.materials = {0};
  Lattice lattice(mesh, options);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      const auto at = [&](int i, int j) {
        glm::ivec3 point;
        point[axis] = side;
        // Swapping the two other axes on the far side keeps the front outwards.
        point[(axis + (side == 0 ? 2 : 1)) % 3] = i;
        point[(axis + (side == 0 ? 1 : 2)) % 3] = j;
        return lattice.vertex(point);
      };
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          add_triangle(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1));
          add_triangle(mesh, at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
      }
    }
  }
  return mesh;
}

}  // namespace ps
