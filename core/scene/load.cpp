#include "scene/load.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/resources.h"
#include "base/spelling.h"
#include "scene/obj.h"
#include "scene/scene_file.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

struct BuiltinFile {
  std::string name;
  fs::path path;
};

std::vector<BuiltinFile> builtin_files() {
  std::vector<BuiltinFile> files;
  std::error_code error;
  const fs::path root = scene_dir();
  for (const auto& folder : fs::directory_iterator(root, error)) {
    for (const auto& file : fs::directory_iterator(folder.path(), error)) {
      if (file.path().extension() != ".scene") continue;
      files.push_back({folder.path().filename().string() + "/" + file.path().stem().string(), file.path()});
    }
  }
  std::sort(files.begin(), files.end(), [](const BuiltinFile& a, const BuiltinFile& b) { return a.name < b.name; });
  return files;
}

Scene load_scene_file(const fs::path& path) {
  return parse_scene(read_text_file(path, max_scene_file_bytes), path.string(), path.parent_path());
}

std::vector<BuiltinScene> read_headings() {
  std::vector<BuiltinScene> scenes;
  for (const BuiltinFile& file : builtin_files()) {
    try {
      const auto heading = parse_scene_heading(read_text_file(file.path, max_scene_file_bytes), file.path.string());
      scenes.push_back(
          {file.name, heading.title.empty() ? file.name : heading.title, heading.description, heading.keywords});
    } catch (const InputError& error) {
      scenes.push_back({file.name, file.name, error.what(), {}});
    }
  }
  return scenes;
}

}  // namespace

Scene load_scene(const std::string& path_or_builtin_name) {
  const fs::path path = path_or_builtin_name;
  const std::string extension = path.extension().string();
  if (extension == ".scene") return load_scene_file(path);
  if (extension == ".obj" || extension == ".OBJ") return load_obj_scene(path);
  const auto files = builtin_files();
  for (const BuiltinFile& file : files) {
    if (file.name != path_or_builtin_name) continue;
    Scene scene = load_scene_file(file.path);
    if (scene.title == scene.name) scene.title = file.name;
    scene.name = file.name;
    return scene;
  }
  if (fs::exists(path))
    throw InputError({path_or_builtin_name, 0, 0}, "an unknown kind of file", "a .scene or .obj file");
  std::vector<std::string_view> names;
  names.reserve(files.size());
  for (const BuiltinFile& file : files) names.push_back(file.name);
  throw InputError({path_or_builtin_name, 0, 0}, "no such file or built-in scene",
                   names.empty() ? "a .scene or .obj file"
                                 : fmt::format("a .scene or .obj file, or a name such as '{}'",
                                               nearest_word(path_or_builtin_name, names)));
}

const std::vector<BuiltinScene>& builtin_scenes() {
  static const std::vector<BuiltinScene> scenes = read_headings();
  return scenes;
}

std::vector<std::string> files_of(const Scene& scene) { return scene.files; }

}  // namespace ps
