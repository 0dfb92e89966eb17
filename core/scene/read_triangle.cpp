#include <fmt/format.h>

#include "scene/scene_draft.h"

namespace ps {
namespace {

void read_space_triangle(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(
      values, entry,
      joined_keys({"name", "dynamic", "vertices", "normals", "uvs", "material", "sides"}, surface_keys()));
  Mesh mesh;
  MeshTriangle triangle;
  for (const SceneTerm& term : source.values.corners(fields.require("vertices")))
    mesh.positions.push_back(values.vec3(term));
  triangle.position = {0, 1, 2};
  if (const auto* term = fields.find("normals")) {
    for (const SceneTerm& one : source.values.corners(*term)) mesh.normals.push_back(values.direction(one));
    triangle.normal = {0, 1, 2};
  }
  if (const auto* term = fields.find("uvs")) {
    for (const SceneTerm& one : source.values.corners(*term)) mesh.uvs.push_back(values.vec2(one));
    triangle.uv = {0, 1, 2};
  }
  mesh.triangles = {triangle};
  mesh.materials = {material_for(source, fields, {}, draft)};
  if (draft.materials[mesh.materials.front()].texture >= 0 && mesh.uvs.empty())
    values.fail_at(entry.line, entry.column, "a triangle with a texture", "'uvs' too");
  add_single_model(source, fields, "triangle", std::move(mesh), draft);
}

}  // namespace

bool has_vertices_in_space(const SceneEntry& entry) {
  for (const SceneEntry& field : entry.value.entries)
    if (field.key == "vertices" && !field.value.items.empty()) return field.value.items.front().items.size() == 3;
  return false;
}

void add_single_model(const SceneSource& source, const SceneFields& fields, std::string_view kind, Mesh mesh,
                      SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneTerm* name = fields.find("name");
  mesh.name = name != nullptr ? values.name(*name) : std::string(kind);
  for (int number = 2; draft.mesh_index.count(mesh.name) > 0; ++number)
    mesh.name = fmt::format("{} {}", name != nullptr ? values.name(*name) : std::string(kind), number);
  Instance instance;
  instance.mesh = static_cast<std::uint32_t>(draft.geometry.meshes.size());
  if (const auto* term = fields.find("sides")) instance.sides = read_sides(values, *term);
  draft.mesh_index[mesh.name] = instance.mesh;
  draft.geometry.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
  add_object(source, fields, {{}, instance}, draft);
}

void read_any_triangle(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  if (has_vertices_in_space(entry))
    read_space_triangle(source, entry, draft);
  else
    read_canvas_triangle(source, entry, draft);
}

}  // namespace ps
