#include "document/scene_edits.h"

#include "scene/contents.h"
#include "scene/edit.h"

namespace ps {

Scene edited_scene(Scene scene, const std::vector<SceneEdit>& edits) {
  for (const SceneEdit& edit : edits) {
    if (changes_contents(edit.path))
      change_contents(scene, edit.path, edit.value);
    else
      set_property(scene, edit.path, edit.value);
  }
  return scene;
}

View view_of(const Scene& scene, const std::optional<Camera>& camera, int width, int height) {
  return {camera.value_or(scene.camera), width > 0 ? width : scene.canvas_width,
          height > 0 ? height : scene.canvas_height};
}

}  // namespace ps
