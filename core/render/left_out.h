#pragma once
#include <string>
#include <vector>

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

/// What the chosen renderer cannot show of a scene with these traits; empty if it shows everything.
std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings);

/// Whether it shows no object at all of a scene that has some: its picture is nothing but background.
bool leaves_out_all(const SceneTraits& traits, const Settings& settings);

/// The same for the end of a verdict: "; the rasterizer leaves out CSG"; empty if nothing is left out.
std::string left_out_words(const SceneTraits& traits, const Settings& settings);

}  // namespace ps
