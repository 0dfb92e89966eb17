#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace ps {

/// One change to the scene as it was loaded: a path and a value as set_property of scene/edit.h reads them.
struct SceneEdit {
  std::string path;
  std::string value;
  bool operator==(const SceneEdit&) const = default;
};

/// The scene with the edits, applied in their order. Throws InputError when one does not fit it.
Scene edited_scene(Scene scene, const std::vector<SceneEdit>& edits);

}  // namespace ps
