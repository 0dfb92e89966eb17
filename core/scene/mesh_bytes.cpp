#include "scene/mesh_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/number_text.h"

namespace ps {

MeshBytes bytes_of_mesh(const Mesh& mesh) {
  constexpr std::uint64_t number = 4, index = 4;
  const bool normals = !mesh.normals.empty(), uvs = !mesh.uvs.empty();
  const std::uint64_t vertex = number * (3 + (normals ? 3u : 0u) + (uvs ? 2u : 0u));
  std::vector<std::array<std::int64_t, 3>> vertices;
  vertices.reserve(3 * mesh.triangles.size());
  for (const MeshTriangle& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) vertices.push_back({triangle.position[k], triangle.normal[k], triangle.uv[k]});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  MeshBytes bytes;
  bytes.triangles = mesh.triangles.size();
  bytes.vertices = vertices.size();
  bytes.shared = bytes.vertices * vertex + 3 * index * bytes.triangles;
  bytes.unshared = 3 * vertex * bytes.triangles;
  return bytes;
}

MeshBytes bytes_of_meshes(const Scene& scene) {
  MeshBytes all;
  for (const auto& mesh : scene.geometry->meshes) {
    const MeshBytes one = bytes_of_mesh(*mesh);
    all.triangles += one.triangles;
    all.vertices += one.vertices;
    all.shared += one.shared;
    all.unshared += one.unshared;
  }
  return all;
}

std::string mesh_bytes_text(const MeshBytes& bytes) {
  if (bytes.triangles == 0) return "";
  const auto digits = [](std::uint64_t count) { return with_thousands(std::to_string(count)); };
  return fmt::format("{} vertices for {} triangles: {} bytes shared, {} bytes unshared", digits(bytes.vertices),
                     digits(bytes.triangles), digits(bytes.shared), digits(bytes.unshared));
}

}  // namespace ps
