#pragma once
#include <filesystem>
#include <string>

#include "scene/load.h"

namespace ps::test {

/// A folder for the files of one test, removed with everything in it at the end.
class ModelFolder {
 public:
  ModelFolder();
  ~ModelFolder();
  ModelFolder(const ModelFolder&) = delete;
  ModelFolder& operator=(const ModelFolder&) = delete;

  std::string write(const std::string& name, const std::string& text) const;
  Scene load(const std::string& obj_text) const { return load_scene(write("model.obj", obj_text)); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The only mesh of a scene.
inline const Mesh& mesh_of(const Scene& scene) { return *scene.geometry->meshes.at(0); }

}  // namespace ps::test
