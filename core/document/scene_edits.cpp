#include "document/scene_edits.h"

#include "scene/edit.h"

namespace ps {

Scene edited_scene(Scene scene, const std::vector<SceneEdit>& edits) {
  for (const SceneEdit& edit : edits) set_property(scene, edit.path, edit.value);
  return scene;
}

}  // namespace ps
