#include "scene/obj_material.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "image/file.h"
#include "image/height_map.h"
#include "scene/mtl_check.h"
#include "scene/scene_file.h"
#include "scene/scene_value.h"
#include "scene/texture_generator.h"

namespace ps {
namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t max_mtl_bytes = std::uintmax_t{16} << 20;

/// The file as named; else, as exporters write paths of their own machine, the same name beside the model.
std::optional<fs::path> find_file(const fs::path& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  std::error_code ignored;
  for (const fs::path& path : {folder / name, folder / fs::path(name).filename()})
    if (fs::is_regular_file(path, ignored)) return path;
  return {};
}

class MaterialLoader {
 public:
  MaterialLoader(const fs::path& obj, ObjModel& model) : obj_(obj), folder_(obj.parent_path()), model_(model) {}

  /// `names` is what follows mtllib: one name with or without blanks, or several names.
  void load_all(const ObjReference& names) {
    if (const auto path = find_file(folder_, names.name)) return load(*path);
    std::istringstream words(names.name);
    std::string word;
    while (words >> word) {
      if (const auto path = find_file(folder_, word)) {
        load(*path);
      } else {
        model_.warnings.push_back(
            fmt::format("{}:{}: the material file '{}' is missing.", obj_.string(), names.line, word));
      }
    }
  }

  std::map<std::string, std::uint32_t> by_name;

  void load(const fs::path& path) { parse(read_text_file(path, max_mtl_bytes), path); }

  void parse(std::string text, const fs::path& path) {
    const MtlSummary summary = check_mtl(text, path.string());
    model_.warnings.insert(model_.warnings.end(), summary.notes.begin(), summary.notes.end());
    model_.files.push_back(path.string());
    std::istringstream stream(text);
    std::map<std::string, int> ignored_map;
    std::vector<tinyobj::material_t> materials;
    std::string warnings, errors;
    tinyobj::LoadMtl(&ignored_map, &materials, &stream, &warnings, &errors);
    for (tinyobj::material_t& material : materials) {
      // tinyobjloader keeps blanks around names, and makes a material without a name for a file without any.
      material.name.erase(material.name.find_last_not_of(" \t") + 1);
      material.name.erase(0, material.name.find_first_not_of(" \t"));
      const auto facts = summary.materials.find(material.name);
      if (facts == summary.materials.end()) continue;
      if (!by_name.emplace(material.name, static_cast<std::uint32_t>(model_.materials.size())).second) continue;
      model_.materials.push_back(convert(material, facts->second, path));
    }
  }

 private:
  Material convert(const tinyobj::material_t& from, const MtlFacts& facts, const fs::path& mtl) {
    const auto colour = [](const tinyobj::real_t* c) { return glm::max(Vec3d{c[0], c[1], c[2]}, Vec3d{0, 0, 0}); };
    Material material;
    material.name = from.name;
    if (facts.diffuse) material.colour = colour(from.diffuse);
    const Vec3d specular = colour(from.specular);
    const bool matte = facts.illum == 0 || facts.illum == 1;
    if (specular != Vec3d{0, 0, 0} && from.shininess > 0 && !matte) {
      material.specular = from.shininess;
      material.specular_colour = specular;
    }
    // Black and white are what exporters write for every material, whatever its colour; they carry no intention.
    const Vec3d ambient = colour(from.ambient);
    if (ambient != Vec3d{0, 0, 0} && ambient != Vec3d{1, 1, 1}) material.ambient_colour = ambient;
    if (facts.diffuse_map) material.texture = texture(*facts.diffuse_map, mtl);
    if (facts.relief_map) add_relief(*facts.relief_map, facts.bump, mtl, material);
    material.transparency = 1 - facts.dissolve.value_or(1);
    // Exporters write Ni for every material; light bends only where illum says so.
    const bool refracts = facts.illum == 6 || facts.illum == 7;
    if (material.transparency > 0 && refracts)
      material.refraction_index =
          std::clamp(facts.refraction_index.value_or(1), min_refraction_index, max_refraction_index);
    // Models 3 to 7 trace reflections; what is transparent shares its light between both by the option for it.
    const bool mirrors = facts.illum && *facts.illum >= 3 && *facts.illum <= 7;
    if (mirrors && material.transparency == 0)
      material.reflective = std::min((specular.x + specular.y + specular.z) / 3, 1.0);
    return material;
  }

  int texture(const MtlTexture& map, const fs::path& mtl) {
    const auto path = find_file(mtl.parent_path(), map.name);
    if (!path) {
      model_.warnings.push_back(fmt::format("{}:{}: the texture '{}' is missing.", mtl.string(), map.line, map.name));
      return -1;
    }
    const auto known = textures_.find(path->string());
    if (known != textures_.end()) return known->second;
    auto texels = std::make_shared<const Image<Vec3f>>(load_image(*path));
    model_.textures.push_back({path->stem().string(), path->string(), std::move(texels)});
    model_.files.push_back(path->string());
    const int index = static_cast<int>(model_.textures.size()) - 1;
    textures_[path->string()] = index;
    return index;
  }

  /// A normal map as it is; heights, which are grey, turned into one. How steep a bump map is meant, the format leaves
  /// open: here white lies as many texels above black as -bm says times `texels_of_bump`.
  void add_relief(const MtlTexture& map, double bump, const fs::path& mtl, Material& material) {
    const int index = texture(map, mtl);
    material.normal_map = index;
    if (index < 0) return;
    const Texture& source = model_.textures[static_cast<std::size_t>(index)];
    if (!is_height_map(*source.texels) || !(bump > 0)) return;
    constexpr double texels_of_bump = 8;
    const double steepness = bump * texels_of_bump;
    const int source_width = source.texels->width();
    Texture normals{source.name + " relief", source.path, nullptr, heights_generator(steepness)};
    normals.texels = std::make_shared<const Image<Vec3f>>(normals_from_heights(*source.texels, steepness));
    model_.textures.push_back(std::move(normals));
    material.normal_map = static_cast<int>(model_.textures.size()) - 1;
    material.height_map = index;
    material.relief_depth = std::min(steepness / source_width, 1.0);
  }

  const fs::path& obj_;
  fs::path folder_;
  ObjModel& model_;
  std::map<std::string, int> textures_;
};

}  // namespace

std::map<std::string, std::uint32_t> load_obj_materials(const fs::path& obj, const std::vector<ObjReference>& files,
                                                        ObjModel& model) {
  MaterialLoader loader(obj, model);
  for (const ObjReference& file : files) loader.load_all(file);
  return std::move(loader.by_name);
}

std::map<std::string, std::uint32_t> parse_obj_materials(std::string text, const fs::path& path, ObjModel& model) {
  MaterialLoader loader(path, model);
  loader.parse(std::move(text), path);
  return std::move(loader.by_name);
}

}  // namespace ps
