#include "scene/generate/torus_knot.h"

#include <array>
#include <numbers>

#include "base/check.h"
#include "math/portable.h"
#include "math/unit.h"

namespace ps {
namespace {

/// First and second derivative of the centre line.
std::array<Vec3d, 2> derivatives(const TorusKnotOptions& options, double t) {
  const double p = options.turns_around_axis, q = options.turns_around_tube;
  const double c = portable::cos(p * t), s = portable::sin(p * t);
  const double radius = options.major_radius + options.minor_radius * portable::cos(q * t);
  const double radius1 = -q * options.minor_radius * portable::sin(q * t);
  const double radius2 = -q * q * options.minor_radius * portable::cos(q * t);
  const Vec3d first{radius1 * c - p * radius * s, radius1 * s + p * radius * c,
                    q * options.minor_radius * portable::cos(q * t)};
  const Vec3d second{radius2 * c - 2 * p * radius1 * s - p * p * radius * c,
                     radius2 * s + 2 * p * radius1 * c - p * p * radius * s,
                     -q * q * options.minor_radius * portable::sin(q * t)};
  return {first, second};
}

}  // namespace

Vec3d torus_knot_line(const TorusKnotOptions& options, double t) {
  const double p = options.turns_around_axis, q = options.turns_around_tube;
  const double radius = options.major_radius + options.minor_radius * portable::cos(q * t);
  return {radius * portable::cos(p * t), radius * portable::sin(p * t), options.minor_radius * portable::sin(q * t)};
}

Mesh make_torus_knot(const TorusKnotOptions& options) {
  PS_ASSERT(options.segments >= 3 && options.sides >= 3, "a tube needs three segments and three sides");
  const int segments = options.segments, sides = options.sides;
  Mesh mesh;
  mesh.name = "torus knot";
  mesh.materials = {0};
  for (int i = 0; i < segments; ++i) {
    const double t = 2 * std::numbers::pi * i / segments;
    // The Frenet frame: the line is curved everywhere, so it turns smoothly and closes.
    const auto [first, second] = derivatives(options, t);
    const Vec3d tangent = unit_of(first);
    const Vec3d binormal = unit_of(cross(first, second));
    const Vec3d inward = cross(binormal, tangent);
    const Vec3d middle = torus_knot_line(options, t);
    for (int j = 0; j < sides; ++j) {
      const double angle = 2 * std::numbers::pi * j / sides;
      const Vec3d normal = unit_of(portable::cos(angle) * inward + portable::sin(angle) * binormal);
      mesh.normals.push_back(normal);
      mesh.positions.push_back(middle + options.tube_radius * normal);
    }
  }
  for (int i = 0; i <= segments; ++i)
    for (int j = 0; j <= sides; ++j)
      mesh.uvs.push_back({static_cast<double>(i) / segments, static_cast<double>(j) / sides});

  const auto add = [&](std::array<int, 3> along, std::array<int, 3> around) {
    MeshTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const int vertex = along[k] % segments * sides + around[k] % sides;
      triangle.position[k] = static_cast<std::uint32_t>(vertex);
      triangle.normal[k] = vertex;
      triangle.uv[k] = along[k] * (sides + 1) + around[k];
    }
    mesh.triangles.push_back(triangle);
  };
  for (int i = 0; i < segments; ++i) {
    for (int j = 0; j < sides; ++j) {
      add({i, i, i + 1}, {j, j + 1, j + 1});
      add({i, i + 1, i + 1}, {j, j + 1, j});
    }
  }
  return mesh;
}

}  // namespace ps
