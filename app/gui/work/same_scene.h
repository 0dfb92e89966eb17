#pragma once
#include "scene/scene.h"

namespace ps::gui {

/// Whether two scenes look alike from any camera: their parts are the same revisions.
inline bool same_scene(const Scene& a, const Scene& b) {
  return a.geometry.revision() == b.geometry.revision() && a.lights.revision() == b.lights.revision() &&
         a.materials.revision() == b.materials.revision() && a.textures.revision() == b.textures.revision() &&
         a.background == b.background;
}

}  // namespace ps::gui
