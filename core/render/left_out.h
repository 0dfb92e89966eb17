#pragma once
#include <string>
#include <vector>

#include "frame/left_out.h"

namespace ps {

/// The parts of a scene with these traits that the chosen renderer cannot show; empty if it shows everything.
std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings);

/// The texts of several briefs, with one "leaves out": "leaves out shadows and CSG", "rounds places in float".
std::vector<std::string> briefs_together(const std::vector<LeftOutBrief>& briefs);

/// Whether it shows no object at all of a scene that has some: its picture is only background.
bool leaves_out_all(const SceneTraits& traits, const Settings& settings);

/// The same for the end of a verdict: "; the rasterizer leaves out CSG and shadows"; empty if none is left out.
std::string left_out_words(const SceneTraits& traits, const Settings& settings);

}  // namespace ps
