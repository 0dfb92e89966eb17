#include <map>

#include <fmt/format.h>

#include "scene/colour_name.h"
#include "scene/generate/teapot.h"
#include "scene/obj.h"
#include "scene/scene_draft.h"
#include "scene/sphere_mesh.h"

namespace ps {
namespace {

using Kind = SceneTerm::Kind;

/// Vertices, normals or texture coordinates by the names that the file gives them ("0", "A").
using Names = std::map<std::string, std::uint32_t, std::less<>>;

/// Gathers the triangles of one model and the materials that they need.
class ModelReader {
 public:
  ModelReader(const SceneSource& source, const SceneFields& fields, SceneDraft& draft)
      : source_(source), values_(source.values), fields_(fields), draft_(draft) {}

  Mesh spelled_out() {
    mesh_.name = values_.name(fields_.require("name"));
    const SceneTerm& vertices = fields_.require("vertices");
    const SceneTerm& triangles = fields_.require("triangles");
    read_all(vertices, positions_, [&](const SceneTerm& t) { mesh_.positions.push_back(values_.vec3(t)); });
    if (const auto* term = fields_.find("normals"))
      read_all(*term, normals_, [&](const SceneTerm& t) { mesh_.normals.push_back(values_.direction(t)); });
    if (const auto* term = fields_.find("uvs"))
      read_all(*term, uvs_, [&](const SceneTerm& t) { mesh_.uvs.push_back(values_.vec2(t)); });
    read_slots();
    Names numbers;
    read_all(triangles, numbers, [&](const SceneTerm& t) { triangle(t); });
    if (mesh_.triangles.empty()) values_.fail(triangles, "at least one triangle");
    return std::move(mesh_);
  }

  Mesh sphere() {
    mesh_ = make_sphere_mesh(values_.whole(fields_.require("sphere_divisions"), 3, 200));
    mesh_.name = values_.name(fields_.require("name"));
    mesh_.materials = {material_for(source_, fields_, {}, draft_)};
    return std::move(mesh_);
  }

  Mesh generated() {
    const SceneTerm& generator = fields_.require("generator");
    if (values_.name(generator) != "teapot") values_.fail(generator, "teapot");
    TeapotOptions options;
    if (const auto* term = fields_.find("divisions")) options.divisions = values_.whole(*term, 1, 64);
    mesh_ = make_teapot(options);
    mesh_.name = values_.name(fields_.require("name"));
    mesh_.materials = {material_for(source_, fields_, {}, draft_)};
    return std::move(mesh_);
  }

  /// A model from an OBJ file. It brings its own materials unless the block gives others: `materials` for each slot, or
  /// one surface for all.
  Mesh from_file() {
    const SceneTerm& file = fields_.require("file");
    ObjModel model = load_obj((source_.folder / values_.name(file, "a file name")).lexically_normal());
    mesh_ = std::move(model.mesh);
    const std::size_t slots = mesh_.materials.size();
    mesh_.name = values_.name(fields_.require("name"));
    auto& files = draft_.scene.files;
    files.insert(files.end(), model.files.begin(), model.files.end());
    const bool own_surface = fields_.find("material") != nullptr || has_surface(fields_);
    if (const SceneTerm* list = fields_.find("materials")) {
      mesh_.materials.clear();
      read_slots();
      if (mesh_.materials.size() != slots)
        values_.fail(*list, fmt::format("{} materials, one for each of the model's", slots));
    } else if (own_surface) {
      mesh_.materials.assign(slots, material_for(source_, fields_, {}, draft_));
    } else {
      add_materials(std::move(model));
    }
    return std::move(mesh_);
  }

 private:
  /// Names of materials and textures from the file get the model's name before them, as two models may share some.
  void add_materials(ObjModel model) {
    const auto first_material = static_cast<std::uint32_t>(draft_.materials.size());
    const int first_texture = static_cast<int>(draft_.textures.size());
    for (Texture& texture : model.textures) {
      texture.name = fmt::format("{}/{}", mesh_.name, texture.name);
      while (!draft_.texture_index.emplace(texture.name, static_cast<int>(draft_.textures.size())).second)
        texture.name += "'";
      draft_.texels += texture.texels->pixels().size();
      draft_.textures.push_back(std::move(texture));
    }
    for (Material& material : model.materials) {
      material.name = fmt::format("{}/{}", mesh_.name, material.name.empty() ? "plain" : material.name);
      while (!draft_.material_index.emplace(material.name, static_cast<std::uint32_t>(draft_.materials.size())).second)
        material.name += "'";
      for (int* map : {&material.texture, &material.normal_map, &material.height_map, &material.specular_map,
                       &material.ambient_map, &material.opacity_map, &material.reflection_map})
        if (*map >= 0) *map += first_texture;
      draft_.materials.push_back(std::move(material));
    }
    for (std::uint32_t& slot : mesh_.materials) slot += first_material;
    auto& warnings = draft_.scene.warnings;
    warnings.insert(warnings.end(), model.warnings.begin(), model.warnings.end());
  }

  /// Both printed forms: a block of `KEY = VALUE`, or values alone, which are then numbered from 0.
  template <class Read>
  void read_all(const SceneTerm& term, Names& names, Read read) {
    if (term.kind == Kind::list) {
      for (const SceneTerm& item : term.items) {
        names.emplace(std::to_string(names.size()), static_cast<std::uint32_t>(names.size()));
        read(item);
      }
      return;
    }
    if (term.kind != Kind::block) values_.fail(term, "a list in { } or [ ]");
    for (const SceneEntry& entry : term.entries) {
      const std::string name = entry.key.empty() ? std::to_string(names.size()) : entry.key;
      if (!names.emplace(name, static_cast<std::uint32_t>(names.size())).second)
        values_.fail_at(entry.line, entry.column, fmt::format("a second '{}'", name.substr(0, 60)),
                        "a name or number that is still free");
      read(entry.value);
    }
  }

  /// `materials = [steel, gold]` fixes the material slots and their order.
  void read_slots() {
    const SceneTerm* term = fields_.find("materials");
    if (term == nullptr) return;
    if (fields_.find("material") != nullptr || has_surface(fields_))
      values_.fail(*term, "no other surface beside 'materials'");
    if (!term->is_list() || term->items.empty()) values_.fail(*term, "a list of materials such as [steel, gold]");
    for (const SceneTerm& item : term->items) mesh_.materials.push_back(find_material(source_, item, draft_));
  }

  void triangle(const SceneTerm& term) {
    if (term.kind == Kind::block) return triangle_block(term);
    if (!term.is_list() || (term.items.size() != 3 && term.items.size() != 4))
      values_.fail(term, "three vertices and perhaps a colour, such as 0, 1, 2, red");
    MeshTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) triangle.position[i] = index(term.items[i], positions_, "vertex");
    triangle.material = term.items.size() == 4 ? coloured_slot(term.items[3]) : default_slot();
    add(triangle, term);
  }

  void triangle_block(const SceneTerm& term) {
    const SceneEntry entry{"triangle", term, term.line, term.column};
    const SceneFields fields(values_, entry, {"vertices", "normals", "uvs", "color", "material"});
    MeshTriangle triangle;
    const auto& vertices = three(fields.require("vertices"));
    for (std::size_t i = 0; i < 3; ++i) triangle.position[i] = index(vertices[i], positions_, "vertex");
    if (const auto* list = fields.find("normals")) {
      for (std::size_t i = 0; i < 3; ++i)
        triangle.normal[i] = corner(three(*list)[i], normals_, "normal", mesh_.normals, given_normals_,
                                    [&](const SceneTerm& t) { return values_.direction(t); });
    }
    if (const auto* list = fields.find("uvs")) {
      for (std::size_t i = 0; i < 3; ++i)
        triangle.uv[i] = corner(three(*list)[i], uvs_, "texture coordinate", mesh_.uvs, given_uvs_,
                                [&](const SceneTerm& t) { return values_.vec2(t); });
    }
    if (const auto* material = fields.find("material")) {
      fields.forbid({"color"}, "only one of 'color' and 'material'");
      triangle.material = slot(find_material(source_, *material, draft_));
    } else if (const auto* colour = fields.find("color")) {
      triangle.material = coloured_slot(*colour);
    } else {
      triangle.material = default_slot();
    }
    add(triangle, term);
  }

  void add(const MeshTriangle& triangle, const SceneTerm& term) {
    const Material& material = draft_.materials[mesh_.materials[triangle.material]];
    if (needs_uv(material) && triangle.uv[0] < 0)
      values_.fail(term, "texture coordinates, since the model has a texture");
    mesh_.triangles.push_back(triangle);
  }

  const std::vector<SceneTerm>& three(const SceneTerm& term) const {
    if (!term.is_list() || term.items.size() != 3) values_.fail(term, "three values, one for each vertex");
    return term.items;
  }

  std::uint32_t index(const SceneTerm& term, const Names& names, std::string_view what) const {
    const auto found = term.kind == Kind::word || term.kind == Kind::quoted ? names.find(term.text) : names.end();
    if (found != names.end()) return found->second;
    if (names.empty()) values_.fail(term, fmt::format("a {}, but the model has none", what));
    values_.fail(term, fmt::format("a {} of the model, which has {}", what, names.size()));
  }

  /// A vertex's value: a name from the model's own list, or spelled out; equal ones are then stored once.
  template <class Vec, class Read>
  std::int32_t corner(const SceneTerm& term, const Names& names, std::string_view what, std::vector<Vec>& stored,
                      std::map<std::array<double, 3>, std::int32_t>& given, Read read) {
    if (term.kind != Kind::tuple) return static_cast<std::int32_t>(index(term, names, what));
    const Vec value = read(term);
    std::array<double, 3> key{};
    for (int axis = 0; axis < Vec::length(); ++axis) key[static_cast<std::size_t>(axis)] = value[axis];
    const auto [place, is_new] = given.try_emplace(key, static_cast<std::int32_t>(stored.size()));
    if (is_new) stored.push_back(value);
    return place->second;
  }

  std::uint32_t slot(std::uint32_t material) {
    for (std::size_t i = 0; i < mesh_.materials.size(); ++i)
      if (mesh_.materials[i] == material) return static_cast<std::uint32_t>(i);
    mesh_.materials.push_back(material);
    return static_cast<std::uint32_t>(mesh_.materials.size() - 1);
  }

  /// The slot of triangles that name no colour of their own.
  std::uint32_t default_slot() {
    if (fields_.find("materials") != nullptr) return 0;
    if (!default_material_) default_material_ = material_for(source_, fields_, {}, draft_);
    return slot(*default_material_);
  }

  /// The slot of the model's surface in another colour.
  std::uint32_t coloured_slot(const SceneTerm& term) {
    const bool is_name = term.kind == Kind::word || term.kind == Kind::quoted;
    if (is_name && !named_colour(term.text) && draft_.material_index.count(term.text) > 0)
      return slot(draft_.material_index.at(term.text));
    const Vec3d colour = values_.colour(term);
    const auto found = coloured_.find({colour.x, colour.y, colour.z});
    if (found != coloured_.end()) return found->second;
    Material material;
    if (const auto* named = fields_.find("material"))
      material = draft_.materials[find_material(source_, *named, draft_)];
    material = read_surface(source_, fields_, material, draft_);
    material.name.clear();
    material.colour = colour;
    draft_.materials.push_back(material);
    const std::uint32_t made = slot(static_cast<std::uint32_t>(draft_.materials.size() - 1));
    coloured_[{colour.x, colour.y, colour.z}] = made;
    return made;
  }

  const SceneSource& source_;
  const SceneValues& values_;
  const SceneFields& fields_;
  SceneDraft& draft_;
  Mesh mesh_;
  Names positions_, normals_, uvs_;
  std::map<std::array<double, 3>, std::int32_t> given_normals_, given_uvs_;
  std::optional<std::uint32_t> default_material_;
  std::map<std::array<double, 3>, std::uint32_t> coloured_;
};

}  // namespace

void read_model(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry,
                           joined_keys({"name", "file", "vertices", "triangles", "normals", "uvs", "sphere_divisions",
                                        "generator", "divisions", "material", "materials"},
                                       surface_keys()));
  const SceneTerm& name = fields.require("name");
  if (draft.mesh_index.count(values.name(name)) > 0) values.fail(name, "a name that no other model has");
  Mesh mesh;
  if (fields.find("file") != nullptr) {
    fields.forbid({"vertices", "triangles", "normals", "uvs", "sphere_divisions"}, "no shape beside 'file'");
    mesh = ModelReader(source, fields, draft).from_file();
  } else if (fields.find("generator") != nullptr) {
    fields.forbid({"vertices", "triangles", "normals", "uvs", "sphere_divisions", "materials"},
                  "no shape beside 'generator'");
    mesh = ModelReader(source, fields, draft).generated();
  } else if (fields.find("sphere_divisions") != nullptr) {
    fields.forbid({"vertices", "triangles", "normals", "uvs", "materials"}, "no shape beside 'sphere_divisions'");
    mesh = ModelReader(source, fields, draft).sphere();
  } else {
    mesh = ModelReader(source, fields, draft).spelled_out();
  }
  charge_triangles(source, entry, mesh.triangles.size(), draft);
  charge_texels(source, entry, 0, draft);  // those of a model's own textures are counted already
  draft.mesh_index[mesh.name] = static_cast<std::uint32_t>(draft.geometry.meshes.size());
  draft.geometry.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
}

}  // namespace ps
