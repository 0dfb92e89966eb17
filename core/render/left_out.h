#pragma once
#include <string>
#include <vector>

#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// Something of a scene that a renderer cannot show.
struct LeftOut {
  std::string brief;     ///< a few words: "leaves out CSG"
  std::string sentence;  ///< a whole one, with the reason
};

/// What the chosen renderer cannot show of a scene with these traits; empty if it shows everything.
std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings);

}  // namespace ps
