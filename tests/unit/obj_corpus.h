#pragma once
#include <filesystem>
#include <string>

#include "scene/load.h"
#include "support/run_cli.h"

namespace ps::test {

/// A folder for a model and its files.
class ModelFolder : public ScratchFolder {
 public:
  Scene load(const std::string& obj_text) const { return load_scene(write("model.obj", obj_text)); }
};

/// The warnings of a scene, one a line, each from the name of its file on.
inline std::string notes_of(const Scene& scene) {
  std::string all;
  for (const std::string& warning : scene.warnings) all += warning.substr(warning.rfind('/') + 1) + "\n";
  return all;
}

/// The only mesh of a scene.
inline const Mesh& mesh_of(const Scene& scene) { return *scene.geometry->meshes.at(0); }

}  // namespace ps::test
