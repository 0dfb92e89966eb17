#include <array>
#include <map>
#include <vector>

#include "bench/llvmpipe/gl_scene.h"

namespace ps::bench {
namespace {

struct GlVertex {
  Vec3f position, normal;
  Vec2f uv;
};

}  // namespace

void GlScene::upload_mesh(const Mesh& mesh) {
  // OpenGL has one index for position, normal and texture coordinate together.
  std::map<std::array<std::int64_t, 3>, std::uint32_t> known;
  std::vector<GlVertex> vertices;
  std::vector<std::uint32_t> indices;
  for (const MeshTriangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<std::int64_t, 3> key{triangle.position[k], triangle.normal[k], triangle.uv[k]};
      const auto [place, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(vertices.size()));
      indices.push_back(place->second);
      if (!is_new) continue;
      GlVertex vertex{Vec3f(mesh.positions[triangle.position[k]]), {0, 0, 1}, {0, 0}};
      if (triangle.normal[k] >= 0) vertex.normal = Vec3f(mesh.normals[static_cast<std::size_t>(triangle.normal[k])]);
      if (triangle.uv[k] >= 0) vertex.uv = Vec2f(mesh.uvs[static_cast<std::size_t>(triangle.uv[k])]);
      vertices.push_back(vertex);
    }
  }
  index_count_ = static_cast<GLsizei>(indices.size());
  glGenVertexArrays(1, &vertex_array_);
  glBindVertexArray(vertex_array_);
  glGenBuffers(1, &vertices_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(GlVertex)), vertices.data(),
               GL_STATIC_DRAW);
  glGenBuffers(1, &indices_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
               GL_STATIC_DRAW);
  const auto attribute = [](GLuint place, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(place);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes the offset as a pointer
    glVertexAttribPointer(place, size, GL_FLOAT, GL_FALSE, sizeof(GlVertex), reinterpret_cast<const void*>(offset));
  };
  attribute(0, 3, offsetof(GlVertex, position));
  attribute(1, 3, offsetof(GlVertex, normal));
  attribute(2, 2, offsetof(GlVertex, uv));
}

}  // namespace ps::bench
