#include "scene/obj_material.h"

#include <algorithm>

#include <fmt/format.h>

#include "image/file.h"
#include "image/height_map.h"
#include "scene/model_files.h"
#include "scene/mtl_check.h"
#include "scene/picture_fault.h"
#include "scene/scene_file.h"
#include "scene/scene_value.h"
#include "scene/texture_generator.h"

namespace ps {
namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t max_mtl_bytes = std::uintmax_t{16} << 20;

class MaterialLoader {
 public:
  MaterialLoader(const fs::path& obj, ObjModel& model) : obj_(obj), folder_(obj.parent_path()), model_(model) {}

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
        load(*path);
        first = last + 1;
        continue;
      }
      warn(obj_, names.line,
           fmt::format("the material file '{}' is missing",
                       names.name.substr(starts[first], ends[first] - starts[first])));
      ++first;
    }
  }

  std::map<std::string, std::uint32_t> by_name;

  void load(const fs::path& path) { parse(read_text_file(path, max_mtl_bytes), path); }

  void parse(std::string text, const fs::path& path) {
    const MtlSummary summary = check_mtl(text, path.string());
    model_.warnings.insert(model_.warnings.end(), summary.notes.begin(), summary.notes.end());
    model_.files.push_back(path.string());
    for (const std::string& name : summary.order) {
      if (!by_name.emplace(name, static_cast<std::uint32_t>(model_.materials.size())).second) continue;
      model_.materials.push_back(convert(name, summary.materials.at(name), path));
    }
  }

 private:
  Material convert(const std::string& name, const MtlFacts& facts, const fs::path& mtl) {
    const auto colour = [](const std::optional<Vec3d>& c) {
      return glm::max(c.value_or(Vec3d{0, 0, 0}), Vec3d{0, 0, 0});
    };
    Material material;
    material.name = name;
    if (facts.diffuse) material.colour = colour(facts.diffuse);
    const Vec3d specular = colour(facts.specular);
    const bool matte = facts.illum == 0 || facts.illum == 1;
    const double shininess = facts.shininess.value_or(1);
    if (specular != Vec3d{0, 0, 0} && shininess > 0 && !matte) {
      material.specular = shininess;
      material.specular_colour = specular;
    }
    // Black and white are what exporters write for every material, whatever its colour; they carry no intention.
    const Vec3d ambient = colour(facts.ambient);
    if (ambient != Vec3d{0, 0, 0} && ambient != Vec3d{1, 1, 1}) material.ambient_colour = ambient;
    if (facts.diffuse_map) material.texture = texture(*facts.diffuse_map, mtl);
    if (facts.relief_map) add_relief(*facts.relief_map, mtl, material);
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

  /// The index of the picture; -1, with a warning for the first material that names it, where it cannot be had.
  int texture(const MtlTexture& map, const fs::path& mtl) {
    const auto path = files_.find({mtl.parent_path(), folder_}, map.name);
    const auto [known, is_new] = textures_.try_emplace(path ? path->string() : "missing " + map.name, -1);
    if (!is_new) return known->second;
    if (!path) {
      warn(mtl, map.line, fmt::format("the texture '{}' is missing", map.name));
      return -1;
    }
    model_.files.push_back(path->string());  // also one that cannot be read: it may be repaired while the model is open
    try {
      add_texture(path->stem().string(), *path, load_image(*path, {.most_pixels = texels_left_}), {});
    } catch (const InputError& error) {
      warn(mtl, map.line,
           fmt::format("the texture '{}' cannot be read, so the surface goes without it: {}", map.name,
                       picture_fault(*path, error)));
      return -1;
    }
    return known->second = static_cast<int>(model_.textures.size()) - 1;
  }

  void add_texture(const std::string& name, const fs::path& path, Image<Vec3f> texels, const std::string& generator) {
    texels_left_ -= static_cast<std::int64_t>(texels.pixels().size());
    model_.textures.push_back(
        {name, path.string(), std::make_shared<const Image<Vec3f>>(std::move(texels)), generator});
  }

  void warn(const fs::path& file, int line, const std::string& text) {
    model_.warnings.push_back(fmt::format("{}:{}: {}.", file.string(), line, text));
  }

  /// A normal map as it is; heights, which are grey, turned into one. How steep a bump map is meant, the format leaves
  /// open: here white lies as many texels above black as -bm says times `texels_of_bump`.
  void add_relief(const MtlTexture& map, const fs::path& mtl, Material& material) {
    const int index = texture(map, mtl);
    material.normal_map = index;
    if (index < 0) return;
    const Texture source = model_.textures[static_cast<std::size_t>(index)];
    if (!is_height_map(*source.texels) || !(map.bump > 0)) return;
    const auto texels = static_cast<std::int64_t>(source.texels->pixels().size());
    if (texels > texels_left_) {
      material.normal_map = -1;
      warn(mtl, map.line, fmt::format("no room is left for the normals of the relief '{}'", map.name));
      return;
    }
    constexpr double texels_of_bump = 8;
    const double steepness = map.bump * texels_of_bump;
    add_texture(source.name + " relief", source.path, normals_from_heights(*source.texels, steepness),
                heights_generator(steepness));
    material.normal_map = static_cast<int>(model_.textures.size()) - 1;
    material.height_map = index;
    material.relief_depth = std::min(steepness / source.texels->width(), 1.0);
  }

  const fs::path& obj_;
  fs::path folder_;
  ObjModel& model_;
  ModelFiles files_;
  std::map<std::string, int> textures_;  ///< by path, and by what is missing
  std::int64_t texels_left_ = max_read_pixels;
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
