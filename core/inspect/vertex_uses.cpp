#include "inspect/vertex_uses.h"

#include <fmt/format.h>

#include "record/value_text.h"

namespace ps {

VertexUses vertex_uses(const Scene& scene, const VertexId& id, std::size_t most) {
  const auto& instance = std::get<Instance>(scene.geometry->objects[static_cast<std::size_t>(id.object)].shape);
  const std::vector<MeshTriangle>& triangles = scene.geometry->meshes[instance.mesh]->triangles;
  VertexUses uses;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      if (static_cast<int>(triangles[t].position[static_cast<std::size_t>(corner)]) != id.vertex) continue;
      ++uses.count;
      if (uses.first.size() >= most) continue;
      const auto triangle = static_cast<int>(t);
      if (auto face = face_data(scene, {id.object, triangle}))
        uses.first.push_back({triangle, corner, std::move(*face)});
    }
  return uses;
}

std::string use_text(const CornerUse& use) {
  const FaceCorner& corner = use.face.corners[static_cast<std::size_t>(use.corner)];
  std::string text = fmt::format("triangle {}: {}", use.triangle,
                                 corner.normal ? "normal " + vector_text(*corner.normal) : "no normal");
  text += corner.uv ? ", uv " + vector_text(*corner.uv) : ", no uv";
  if (const std::string origin = origin_text(use.face); !origin.empty()) text += "; " + origin;
  if (corner.faces_away) text += "; the normal faces away from the face";
  return text;
}

}  // namespace ps
