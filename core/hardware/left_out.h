#pragma once
#include <vector>

#include "frame/left_out.h"

namespace ps::hardware {

/// What a picture of such a scene leaves out: shapes and effects that the renderer does not have (lacks.h).
std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings);

}  // namespace ps::hardware
