#pragma once
#include <string>

#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

enum class LeftOutKind {
  objects,  ///< some are not in the picture
  effect    ///< they are, but without something that the settings ask for
};

/// Something of a scene that a renderer cannot show.
struct LeftOut {
  LeftOutKind kind = LeftOutKind::objects;
  std::string brief;     ///< a few words: "leaves out CSG"
  std::string sentence;  ///< a whole one, with the reason and what shows it
};

/// Would the picture have shadows, or reflections, if its renderer could make them?
bool asks_for_shadows(const SceneTraits& traits, const Settings& settings);
bool asks_for_reflections(const SceneTraits& traits, const Settings& settings);

}  // namespace ps
