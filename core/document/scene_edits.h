#pragma once
#include <optional>
#include <string>
#include <vector>

#include "frame/view.h"
#include "scene/scene.h"

namespace ps {

/// One change to the scene as it was loaded: a path and a value as set_property of scene/edit.h reads them, or
/// change_contents of scene/contents.h. Indices in them count in the scene as the edits before this one leave it.
struct SceneEdit {
  std::string path;
  std::string value;
  bool operator==(const SceneEdit&) const = default;
};

/// The scene with the edits, applied in their order. Throws InputError when one does not fit it.
Scene edited_scene(Scene scene, const std::vector<SceneEdit>& edits);

/// The view of the scene: by `camera`, or by its own, in pixels of `width` and `height`, where 0 means those of its
/// canvas.
View view_of(const Scene& scene, const std::optional<Camera>& camera, int width, int height);

}  // namespace ps
