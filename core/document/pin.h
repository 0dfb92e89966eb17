#pragma once
#include <optional>
#include <vector>

#include "document/scene_edits.h"
#include "frame/view.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// A pixel that is kept to compare with: where it was, and all that its two stories followed from. It stores no
/// numbers: its story is recomputed on demand. The scene is that of the document as it is loaded, so where its file has
/// changed meanwhile, the recomputed story is of the changed one.
struct Pin {
  Vec2i pixel{0, 0};  ///< array position, inside the picture of then
  Settings a, b;
  std::vector<SceneEdit> edits;
  std::optional<Camera> camera;  ///< instead of the scene's own
  int width = 0, height = 0;     ///< of the picture, in pixels; 0 = the scene's canvas size
  bool operator==(const Pin&) const = default;
};

/// The place of a pin.
struct PinnedScene {
  Scene scene;
  View view;
};

/// The scene and the view of then; `base` is the scene as it is loaded. Throws InputError when an edit does not fit it,
/// or when the pixel lies outside the picture.
PinnedScene pinned_scene(const Pin& pin, const Scene& base);

}  // namespace ps
