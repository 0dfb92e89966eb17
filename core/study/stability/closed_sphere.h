#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "raytrace/base/geometry.h"

namespace ps::stability {

/// A closed sphere of triangles around `centre`, as floats. Every edge is shared, so no ray from inside may escape.
struct ClosedSphere {
  std::vector<Vec3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  TracedTriangle<float> triangle(std::size_t i) const {
    const auto& corners = triangles[i];
    return {vertices[corners[0]], vertices[corners[1]], vertices[corners[2]], -1};
  }
};

/// A centre off all axes and not round in binary, such as that of Embree's own test of watertightness.
constexpr Vec3d far_centre{148376, 1234, -223423};

inline ClosedSphere closed_sphere(int rings, int segments, double radius, const Vec3d& centre) {
  using std::numbers::pi;
  ClosedSphere mesh;
  const auto index = [&](int ring, int segment) {
    if (ring == 0) return 0u;
    if (ring == rings) return 1u;
    return static_cast<std::uint32_t>(2 + (ring - 1) * segments + segment % segments);
  };
  mesh.vertices = {Vec3f(centre + Vec3d(0, radius, 0)), Vec3f(centre - Vec3d(0, radius, 0))};
  for (int ring = 1; ring < rings; ++ring) {
    for (int segment = 0; segment < segments; ++segment) {
      const double polar = pi * ring / rings, around = 2 * pi * segment / segments;
      const Vec3d unit{std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around)};
      mesh.vertices.push_back(Vec3f(centre + radius * unit));
    }
  }
  for (int ring = 0; ring < rings; ++ring) {
    for (int segment = 0; segment < segments; ++segment) {
      const auto a = index(ring, segment), b = index(ring, segment + 1);
      const auto c = index(ring + 1, segment), d = index(ring + 1, segment + 1);
      if (a != b) mesh.triangles.push_back({a, c, b});
      if (c != d) mesh.triangles.push_back({b, c, d});
    }
  }
  return mesh;
}

}  // namespace ps::stability
