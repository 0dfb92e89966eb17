#include "scene/sphere_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/portable.h"

namespace ps {

Mesh make_sphere_mesh(int divisions) {
  using std::numbers::pi;
  const double step = 2 * pi / divisions;
  Mesh mesh;
  for (int ring = 0; ring <= divisions; ++ring) {
    const double y = 2.0 / divisions * (ring - divisions / 2.0);
    const double radius = std::sqrt(std::max(0.0, 1.0 - y * y));
    for (int i = 0; i < divisions; ++i)
      mesh.positions.emplace_back(radius * portable::cos(i * step), y, radius * portable::sin(i * step));
  }
  mesh.normals = mesh.positions;
  const auto add = [&](int a, int b, int c) {
    MeshTriangle triangle;
    triangle.position = {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)};
    triangle.normal = {a, b, c};
    mesh.triangles.push_back(triangle);
  };
  for (int ring = 0; ring < divisions; ++ring) {
    for (int i = 0; i < divisions; ++i) {
      const int here = ring * divisions + i;
      const int next = ring * divisions + (i + 1) % divisions;
      add(here, next + divisions, next);
      add(here, here + divisions, next + divisions);
    }
  }
  mesh.materials = {0};
  return mesh;
}

}  // namespace ps
