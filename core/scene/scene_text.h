#pragma once
#include <string>

#include "math/vec.h"

namespace ps {

/// Values as a scene file has them. Each text reads back as exactly the same value.
std::string scene_number(double value);
std::string scene_vec(const Vec2d& value);
std::string scene_vec(const Vec3d& value);
/// (255, 0, 0) where three numbers from 0 to 255 give exactly this colour, else linear (1, 0, 0).
std::string scene_colour(const Vec3d& colour);
/// <45 degrees around the Y axis> where that is exactly this matrix, else its rows.
std::string scene_rotation(const Mat3d& rotation);
/// A name with quotation marks if it needs them. Control characters, which no scene file can hold, become '?'.
std::string scene_name(const std::string& name);

}  // namespace ps
