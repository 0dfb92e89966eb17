#include "scene/generate/uv_sphere.h"

#include <numbers>

#include "base/check.h"
#include "math/portable.h"

namespace ps {
namespace {

/// Index of a vertex's position (and normal) and of its texture coordinate.
struct Corner {
  std::uint32_t position;
  std::int32_t uv;
};

void add_triangle(Mesh& mesh, const Corner& a, const Corner& b, const Corner& c) {
  MeshTriangle triangle;
  triangle.position = {a.position, b.position, c.position};
  triangle.normal = {static_cast<int>(a.position), static_cast<int>(b.position), static_cast<int>(c.position)};
  triangle.uv = {a.uv, b.uv, c.uv};
  mesh.triangles.push_back(triangle);
}

}  // namespace

Mesh make_uv_sphere(const UvSphereOptions& options) {
  PS_ASSERT(options.slices >= 3 && options.stacks >= 2, "a sphere needs three slices and two stacks");
  const int slices = options.slices, stacks = options.stacks;
  Mesh mesh;
  mesh.name = "uv sphere";
  mesh.materials = {0};
  mesh.positions.push_back({0, 1, 0});
  for (int stack = 1; stack < stacks; ++stack) {
    const double polar = std::numbers::pi * stack / stacks;
    for (int slice = 0; slice < slices; ++slice) {
      const double angle = 2 * std::numbers::pi * slice / slices;
      mesh.positions.push_back({portable::sin(polar) * portable::cos(angle), portable::cos(polar),
                                -portable::sin(polar) * portable::sin(angle)});
    }
  }
  mesh.positions.push_back({0, -1, 0});
  mesh.normals = mesh.positions;
  for (int stack = 0; stack <= stacks; ++stack) {
    const double shift = stack == 0 || stack == stacks ? 0.5 : 0;  // a pole's triangle is centred on its slice
    for (int slice = 0; slice <= slices; ++slice)
      mesh.uvs.push_back({(slice + shift) / slices, static_cast<double>(stack) / stacks});
  }

  const auto corner = [&](int stack, int slice) {
    const int uv = stack * (slices + 1) + slice;
    if (stack == 0) return Corner{0, uv};
    if (stack == stacks) return Corner{static_cast<std::uint32_t>(mesh.positions.size() - 1), uv};
    return Corner{static_cast<std::uint32_t>(1 + (stack - 1) * slices + slice % slices), uv};
  };
  for (int stack = 0; stack < stacks; ++stack) {
    for (int slice = 0; slice < slices; ++slice) {
      const Corner a = corner(stack, slice), b = corner(stack + 1, slice);
      const Corner c = corner(stack + 1, slice + 1), d = corner(stack, slice + 1);
      if (stack + 1 < stacks) add_triangle(mesh, a, b, c);
      if (stack == 0) continue;  // d is the pole again
      if (stack + 1 < stacks)
        add_triangle(mesh, a, c, d);
      else
        add_triangle(mesh, a, b, d);
    }
  }
  return mesh;
}

}  // namespace ps
