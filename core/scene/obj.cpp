#include "scene/obj.h"

#include <fmt/format.h>

#include "scene/obj_line.h"
#include "scene/obj_material.h"
#include "scene/obj_reader.h"
#include "scene/scene_file.h"
#include "scene/smooth_normals.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

/// The material that a name means; nullopt if no material file has it.
std::optional<std::uint32_t> find_material(const ObjMaterials& materials, const std::string& name) {
  for (const std::string& meant : meant_names(name)) {
    const auto known = materials.by_name.find(meant);
    if (known != materials.by_name.end()) return known->second;
  }
  return {};
}

/// Fills Mesh::materials. Materials that are missing become plain ones, with a warning for the first of them.
void take_materials(const std::vector<ObjReference>& used, const ObjMaterials& materials, ObjModel& model) {
  int warnings_left = 20;
  for (const ObjReference& reference : used) {
    const auto known = find_material(materials, reference.name);
    model.mesh.materials.push_back(known.value_or(static_cast<std::uint32_t>(model.materials.size())));
    if (known) continue;
    Material plain;
    plain.name = reference.name;
    plain.colour = {0.8, 0.8, 0.8};
    model.materials.push_back(std::move(plain));
    if (reference.name.empty() || warnings_left-- <= 0) continue;
    model.warnings.push_back(fmt::format("{}:{}: the material '{}' is missing.", model.mesh.source, reference.line,
                                         reference.name.substr(0, 60)));
  }
}

/// Moves the texture coordinates of each triangle as its material's pictures lie. They count v from the bottom.
void place_uvs(const ObjMaterials& materials, Mesh& mesh) {
  if (materials.placements.empty()) return;
  std::map<std::pair<std::uint32_t, std::int32_t>, std::int32_t> placed;
  for (MeshTriangle& triangle : mesh.triangles) {
    const auto placement = materials.placements.find(mesh.materials[triangle.material]);
    if (placement == materials.placements.end() || triangle.uv[0] < 0) continue;
    const auto& [scale, offset] = placement->second;
    for (std::int32_t& uv : triangle.uv) {
      const auto [known, is_new] =
          placed.try_emplace({placement->first, uv}, static_cast<std::int32_t>(mesh.uvs.size()));
      const Vec2d old = mesh.uvs[static_cast<std::size_t>(uv)];
      if (is_new) {
        mesh.uvs.emplace_back(scale.x * old.x + offset.x, 1 - (scale.y * (1 - old.y) + offset.y));
        mesh.origins.moved_uvs.push_back(uv);
      }
      uv = known->second;
    }
  }
}

}  // namespace

ObjModel load_obj(const fs::path& path) { return parse_obj(read_text_file(path, max_obj_bytes), path); }

ObjModel parse_obj(std::string_view text, const fs::path& path) {
  ObjText said = read_obj_text(text, path.string());
  ObjModel model;
  model.files.push_back(path.string());
  model.warnings = std::move(said.notes);
  model.mesh = std::move(said.mesh);
  model.mesh.name = path.stem().string();
  model.mesh.source = path.string();
  const ObjMaterials materials = load_obj_materials(path, said.material_files, model);
  take_materials(said.materials, materials, model);
  place_uvs(materials, model.mesh);
  if (!said.smoothing_groups.empty()) add_smooth_normals(model.mesh, said.smoothing_groups);
  return model;
}

}  // namespace ps
