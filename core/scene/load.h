#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace ps {

/// Loads a scene: a path to a .scene or .obj file, or the name of a scene that Pixelscope ships with
/// ("cgfs/reflections"). Throws InputError.
Scene load_scene(const std::string& path_or_builtin_name);

/// A scene that Pixelscope ships with.
struct BuiltinScene {
  std::string name;  ///< "cgfs/reflections"
  std::string title;
  std::string description;
  std::string keywords;  ///< other words that people search for, separated by commas
};
/// All of them, sorted by name. Their headings alone are read, once. A scene that cannot be read is listed by its name,
/// with the error as its description.
const std::vector<BuiltinScene>& builtin_scenes();

/// The files that the scene was read from: when one of them changes, the scene should be loaded again.
std::vector<std::string> files_of(const Scene& scene);

}  // namespace ps
