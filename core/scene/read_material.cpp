#include <algorithm>

#include <fmt/format.h>

#include "image/file.h"
#include "image/height_map.h"
#include "scene/picture_fault.h"
#include "scene/scene_draft.h"
#include "scene/texture_generator.h"

namespace ps {

const std::vector<std::string_view>& surface_keys() {
  static const std::vector<std::string_view> keys{"color",          "specular",      "reflective",   "texture",
                                                  "specular_color", "ambient_color", "transparency", "refraction_index",
                                                  "normal_map",     "height_map",    "relief_depth"};
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

template <class Map>
void require_new_name(const SceneSource& source, const SceneTerm& term, const Map& map, std::string_view what) {
  if (map.count(source.values.name(term)) > 0)
    source.values.fail(term, fmt::format("a name that no other {} has", what));
}

/// A picture that cannot be read is a fault of the line that names it.
Image<Vec3f> read_picture(const SceneSource& source, const SceneTerm& term, const std::filesystem::path& path,
                          std::size_t most_pixels) {
  try {
    return load_image(path, {.most_pixels = static_cast<std::int64_t>(most_pixels)});
  } catch (const InputError& error) {
    source.values.fail_at(term.line, term.column,
                          fmt::format("the picture '{}' ({})", path.string(), picture_fault(path, error)),
                          "one that can be read");
  }
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
  if (const auto* term = fields.find("texture"))
    base.texture = find_named(source, *term, draft.texture_index, "texture");
  if (const auto* term = fields.find("normal_map"))
    base.normal_map = find_named(source, *term, draft.texture_index, "texture");
  if (const auto* term = fields.find("height_map"))
    base.height_map = find_named(source, *term, draft.texture_index, "texture");
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
  require_new_name(source, name, draft.material_index, "material");
  Material material = read_surface(source, fields, {}, draft);
  material.name = source.values.name(name);
  draft.material_index[material.name] = static_cast<std::uint32_t>(draft.materials.size());
  draft.materials.push_back(std::move(material));
}

void read_texture(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry, {"name", "file", "heights", "generator", "size"});
  const SceneTerm& name = fields.require("name");
  require_new_name(source, name, draft.texture_index, "texture");
  Texture texture;
  texture.name = values.name(name);
  if (const SceneTerm* file = fields.find("file")) {
    fields.forbid({"generator", "size"}, "only one of 'file' and 'generator'");
    const auto path = (source.folder / values.name(*file, "a file name")).lexically_normal();
    texture.path = path.string();
    draft.scene.files.push_back(texture.path);
    Image<Vec3f> texels = read_picture(source, *file, path, max_scene_texels - draft.texels);
    if (const SceneTerm* heights = fields.find("heights")) {
      texture.generator = heights_generator(values.positive(*heights));
      texels = normals_from_heights(texels, values.positive(*heights));
    }
    texture.texels = std::make_shared<const Image<Vec3f>>(std::move(texels));
    charge_texels(source, entry, texture.texels->pixels().size(), draft);
  } else {
    fields.forbid({"heights"}, "a 'file' beside 'heights'");
    const SceneTerm& generator = fields.require("generator");
    texture.generator = values.name(generator);
    const auto known = texture_generators();
    if (std::find(known.begin(), known.end(), texture.generator) == known.end())
      values.fail(generator, fmt::format("one of {}", fmt::join(known, ", ")));
    const int size = fields.find("size") != nullptr ? values.whole(*fields.find("size"), 1, 4096) : 256;
    charge_texels(source, entry, static_cast<std::size_t>(size) * static_cast<std::size_t>(size), draft);
    texture.texels = std::make_shared<const Image<Vec3f>>(generate_texture(texture.generator, size));
  }
  draft.texture_index[texture.name] = static_cast<int>(draft.textures.size());
  draft.textures.push_back(std::move(texture));
}

}  // namespace ps
