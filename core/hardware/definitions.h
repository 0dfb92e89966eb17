#pragma once
#include <string>

#include "hardware/picture_plan.h"

namespace ps::hardware {

/// What the shaders of a surface must know when they are compiled, as lines "#define NAME VALUE".
std::string definitions(const PicturePlan& plan, const raster::Surface<float>& surface, bool clip_control);

}  // namespace ps::hardware
