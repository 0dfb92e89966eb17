#include <array>

#include <fmt/format.h>

#include "scene/scene_draft.h"

namespace ps {

const std::vector<std::string_view>& surface_keys() {
  static const std::vector<std::string_view> keys{
      "color",        "specular",    "reflective",       "texture",     "specular_color", "ambient_color",
      "transparency", "normal_map",  "refraction_index", "height_map",  "relief_depth",   "specular_map",
      "ambient_map",  "opacity_map", "reflection_map",   "surroundings"};
  return keys;
}

bool has_surface(const SceneFields& fields) {
  for (const auto key : surface_keys())
    if (fields.find(key) != nullptr) return true;
  return false;
}

namespace {

template <class Map>
auto find_named(const SceneSource& source, const SceneTerm& term, const Map& map, std::string_view what) {
  const auto found = map.find(source.values.name(term, fmt::format("the name of a {}", what)));
  if (found == map.end())
    source.values.fail(
        term, map.empty() ? fmt::format("a {} defined before this line", what)
                          : fmt::format("a {} defined before this line, such as '{}'", what, map.begin()->first));
  return found->second;
}

}  // namespace

Material read_surface(const SceneSource& source, const SceneFields& fields, Material base, const SceneDraft& draft) {
  const SceneValues& values = source.values;
  if (const auto* term = fields.find("color")) base.colour = values.colour(*term);
  if (const auto* term = fields.find("specular")) base.specular = values.specular(*term);
  if (const auto* term = fields.find("reflective")) base.reflective = values.in_range(*term, 0, 1);
  if (const auto* term = fields.find("transparency")) base.transparency = values.in_range(*term, 0, 1);
  if (const auto* term = fields.find("refraction_index"))
    base.refraction_index = values.in_range(*term, min_refraction_index, max_refraction_index);
  const std::array<std::pair<std::string_view, int*>, 7> maps{{{"texture", &base.texture},
                                                               {"normal_map", &base.normal_map},
                                                               {"height_map", &base.height_map},
                                                               {"specular_map", &base.specular_map},
                                                               {"ambient_map", &base.ambient_map},
                                                               {"opacity_map", &base.opacity_map},
                                                               {"reflection_map", &base.reflection_map}}};
  for (const auto& [key, map] : maps)
    if (const auto* term = fields.find(key)) *map = find_named(source, *term, draft.texture_index, "texture");
  if (const auto* term = fields.find("surroundings")) {
    const std::string name = values.name(*term);
    if (name != "sphere" && name != "cube") values.fail(*term, "sphere or cube");
    base.surroundings = name == "cube" ? Surroundings::cube : Surroundings::sphere;
  }
  if (const auto* term = fields.find("relief_depth")) base.relief_depth = values.in_range(*term, 0, 1);
  if (const auto* term = fields.find("specular_color")) base.specular_colour = values.colour(*term);
  if (const auto* term = fields.find("ambient_color")) base.ambient_colour = values.colour(*term);
  return base;
}

std::uint32_t find_material(const SceneSource& source, const SceneTerm& name, const SceneDraft& draft) {
  return find_named(source, name, draft.material_index, "material");
}

std::uint32_t material_for(const SceneSource& source, const SceneFields& fields, const Material& base,
                           SceneDraft& draft) {
  if (const auto* term = fields.find("material")) {
    fields.forbid(surface_keys(), "no surface beside 'material'");
    return find_material(source, *term, draft);
  }
  draft.materials.push_back(read_surface(source, fields, base, draft));
  return static_cast<std::uint32_t>(draft.materials.size() - 1);
}

void read_material(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneFields fields(source.values, entry, joined_keys({"name"}, surface_keys()));
  const SceneTerm& name = fields.require("name");
  if (draft.material_index.count(source.values.name(name)) > 0)
    source.values.fail(name, "a name that no other material has");
  Material material = read_surface(source, fields, {}, draft);
  material.name = source.values.name(name);
  draft.material_index[material.name] = static_cast<std::uint32_t>(draft.materials.size());
  draft.materials.push_back(std::move(material));
}

}  // namespace ps
