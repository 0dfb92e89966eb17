#include "scene/obj_material.h"

#include <algorithm>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "image/file.h"
#include "scene/obj_line.h"
#include "scene/scene_file.h"

namespace ps {
namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t max_mtl_bytes = std::uintmax_t{16} << 20;

/// What tinyobjloader cannot tell apart from its own defaults.
struct Stated {
  std::set<std::string> diffuse;  ///< materials that say Kd
  std::set<std::string> matte;    ///< materials with illum 0 or 1, which have no highlight
};

Stated check_mtl(std::string& text, const std::string& file) {
  Stated stated;
  std::string material;
  for_each_obj_line(text, file, [&](ObjLine& line) {
    const std::string word(line.next());
    if (word.empty()) return;
    if (word == "newmtl") {
      material = std::string(line.rest());
      if (material.empty()) line.fail(line.shown(), "the name of a material");
      return;
    }
    const bool colour = word == "Ka" || word == "Kd" || word == "Ks" || word == "Ke";
    const bool number = word == "Ns" || word == "Ni" || word == "illum";
    if (!colour && !number) return;
    if (material.empty()) line.fail(fmt::format("'{}' before any material", word), "'newmtl NAME' first");
    ObjLine value = line;
    for (int i = 0; i < (colour ? 3 : 1); ++i) line.require_number();
    if (!line.next().empty()) line.fail(line.shown(), colour ? "three numbers" : "one number");
    if (word == "Kd") stated.diffuse.insert(material);
    if (const auto illum = value.next(); word == "illum" && (illum == "0" || illum == "1"))
      stated.matte.insert(material);
  });
  return stated;
}

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

 private:
  void load(const fs::path& path) {
    std::string text = read_text_file(path, max_mtl_bytes);
    const Stated stated = check_mtl(text, path.string());
    model_.files.push_back(path.string());
    std::istringstream stream(text);
    std::map<std::string, int> ignored_map;
    std::vector<tinyobj::material_t> materials;
    std::string warnings, errors;
    tinyobj::LoadMtl(&ignored_map, &materials, &stream, &warnings, &errors);
    for (const tinyobj::material_t& material : materials) {
      if (material.name.empty()) continue;  // tinyobjloader makes one for a file without any
      if (!by_name.emplace(material.name, static_cast<std::uint32_t>(model_.materials.size())).second) continue;
      model_.materials.push_back(convert(material, stated, path));
    }
  }

  Material convert(const tinyobj::material_t& from, const Stated& stated, const fs::path& mtl) {
    const auto colour = [](const tinyobj::real_t* c) { return glm::max(Vec3d{c[0], c[1], c[2]}, Vec3d{0, 0, 0}); };
    Material material;
    material.name = from.name;
    if (stated.diffuse.count(from.name) > 0) material.colour = colour(from.diffuse);
    const Vec3d specular = colour(from.specular);
    if (specular != Vec3d{0, 0, 0} && from.shininess > 0 && stated.matte.count(from.name) == 0) {
      material.specular = from.shininess;
      material.specular_colour = specular;
    }
    // Black and white are what exporters write for every material, whatever its colour; they carry no intention.
    const Vec3d ambient = colour(from.ambient);
    if (ambient != Vec3d{0, 0, 0} && ambient != Vec3d{1, 1, 1}) material.ambient_colour = ambient;
    if (!from.diffuse_texname.empty()) material.texture = texture(from.diffuse_texname, mtl);
    return material;
  }

  int texture(const std::string& name, const fs::path& mtl) {
    const auto path = find_file(mtl.parent_path(), name);
    if (!path) {
      model_.warnings.push_back(fmt::format("{}: the texture '{}' is missing.", mtl.string(), name));
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

}  // namespace ps
