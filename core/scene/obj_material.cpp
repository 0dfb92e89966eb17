#include "scene/obj_material.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/model_files.h"
#include "scene/mtl_check.h"
#include "scene/obj_line.h"
#include "scene/obj_textures.h"
#include "scene/scene_file.h"
#include "scene/scene_value.h"

namespace ps {
namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t max_mtl_bytes = std::uintmax_t{16} << 20;

class MaterialLoader {
 public:
  MaterialLoader(const fs::path& obj, ObjModel& model)
      : obj_(obj), folder_(obj.parent_path()), model_(model), textures_(model, folder_) {}

  /// `names` is what follows mtllib: one name with or without blanks, or several. Of the words that are left the
  /// longest run that is a file comes first.
  void load_all(const ObjReference& names) {
    std::vector<std::size_t> starts, ends;  // of the words
    for (std::size_t i = 0; i < names.name.size(); ++i) {
      const bool blank = names.name[i] == ' ' || names.name[i] == '\t';
      const bool inside = starts.size() > ends.size();
      if (!blank && !inside) starts.push_back(i);
      if (blank && inside) ends.push_back(i);
    }
    if (starts.size() > ends.size()) ends.push_back(names.name.size());
    constexpr std::size_t longest_run = 32;  // of words, so that a long line asks for few files
    for (std::size_t first = 0; first < starts.size();) {
      std::size_t last = std::min(first + longest_run, starts.size());
      std::optional<fs::path> path;
      for (; last > first && !path; --last)
        path = files_.find({folder_}, names.name.substr(starts[first], ends[last - 1] - starts[first]));
      if (path) {
        load(*path, names.line);
        first = last + 1;
        continue;
      }
      if (names.name[starts[first]] == '#') return;  // a comment
      warn(obj_, names.line,
           fmt::format("the material file '{}' is missing",
                       names.name.substr(starts[first], ends[first] - starts[first])));
      ++first;
    }
  }

  ObjMaterials found;

  void parse(std::string_view text, const fs::path& path) {
    const MtlSummary summary = check_mtl(text, path.string());
    model_.warnings.insert(model_.warnings.end(), summary.notes.begin(), summary.notes.end());
    model_.files.push_back(path.string());
    for (const std::string& name : summary.order) {
      const auto index = static_cast<std::uint32_t>(model_.materials.size());
      if (!found.by_name.emplace(name, index).second) continue;
      const MtlFacts& facts = summary.materials.at(name);
      if (facts.placement != UvPlacement{}) found.placements[index] = facts.placement;
      model_.materials.push_back(convert(name, facts, path));
    }
    for (const std::string& name : summary.order)
      for (const std::string& meant : meant_names(name)) found.by_name.emplace(meant, found.by_name.at(name));
  }

 private:
  void load(const fs::path& path, int line) {
    try {
      parse(read_text_file(path, max_mtl_bytes), path);
    } catch (const InputError& error) {
      warn(obj_, line, fmt::format("the material file cannot be read: {}", error.what()));
    }
  }

  Material convert(const std::string& name, const MtlFacts& facts, const fs::path& mtl) {
    const auto colour = [](const std::optional<Vec3d>& c) {
      return glm::max(c.value_or(Vec3d{0, 0, 0}), Vec3d{0, 0, 0});
    };
    Material material;
    material.name = name;
    if (facts.diffuse) material.colour = colour(facts.diffuse);
    // A picture of highlights without a colour to multiply it means white.
    const bool only_map = facts.specular_map && !facts.specular;
    const Vec3d specular = only_map ? Vec3d(1) : colour(facts.specular);
    const bool matte = facts.illum == 0 || facts.illum == 1;
    const double shininess = facts.shininess.value_or(1);
    if (specular != Vec3d{0, 0, 0} && shininess > 0 && !matte) {
      material.specular = shininess;
      material.specular_colour = specular;
      if (facts.specular_map) material.specular_map = textures_.read(*facts.specular_map, mtl);
    }
    // Black and white are what exporters write for every material, whatever its colour; they carry no intention.
    const Vec3d ambient = colour(facts.ambient);
    if (ambient != Vec3d{0, 0, 0} && ambient != Vec3d{1, 1, 1}) material.ambient_colour = ambient;
    if (facts.diffuse_map) material.texture = textures_.read(*facts.diffuse_map, mtl);
    // Exporters name map_Kd's picture again; where Ka is missing, ambient light takes the surface's colour anyway.
    const bool same = facts.ambient_map && facts.diffuse_map && facts.ambient_map->name == facts.diffuse_map->name;
    if (facts.ambient_map && (!same || material.ambient_colour))
      material.ambient_map = textures_.read(*facts.ambient_map, mtl);
    if (facts.opacity_map) material.opacity_map = textures_.read(*facts.opacity_map, mtl, MtlMapKind::opacity);
    if (facts.relief_map) textures_.add_relief(*facts.relief_map, mtl, material);
    material.transparency = 1 - facts.dissolve.value_or(1);
    // Exporters write Ni for every material; light bends only where illum says so.
    const bool refracts = facts.illum == 6 || facts.illum == 7;
    if (material.transparency > 0 && refracts)
      material.refraction_index =
          std::clamp(facts.refraction_index.value_or(1), min_refraction_index, max_refraction_index);
    // Models 3 to 7 trace reflections; what is transparent shares its light between both by the option for it.
    const bool mirrors = facts.illum && *facts.illum >= 3 && *facts.illum <= 7;
    const Vec3d mirrored = colour(facts.specular);
    const double share = std::min((mirrored.x + mirrored.y + mirrored.z) / 3, 1.0);
    if (!facts.reflections.empty() && !matte && share > 0) textures_.add_reflections(facts.reflections, mtl, material);
    if ((mirrors && material.transparency == 0) || material.reflection_map >= 0) material.reflective = share;
    return material;
  }

  void warn(const fs::path& file, int line, const std::string& text) {
    model_.warnings.push_back(fmt::format("{}:{}: {}.", file.string(), line, text));
  }

  const fs::path& obj_;
  fs::path folder_;
  ObjModel& model_;
  ModelFiles files_;
  ObjTextures textures_;
};

}  // namespace

ObjMaterials load_obj_materials(const fs::path& obj, const std::vector<ObjReference>& files, ObjModel& model) {
  MaterialLoader loader(obj, model);
  for (const ObjReference& file : files) loader.load_all(file);
  return std::move(loader.found);
}

ObjMaterials parse_obj_materials(std::string_view text, const fs::path& path, ObjModel& model) {
  MaterialLoader loader(path, model);
  loader.parse(text, path);
  return std::move(loader.found);
}

}  // namespace ps
