#pragma once
#include <optional>
#include <string_view>

#include "math/vec.h"

namespace ps {

/// The colour with this name in scene files, with 255 = 1: red, green, blue, yellow, purple, cyan, white, black, grey
/// (or gray), orange, brown. Purple is (255, 0, 255), as the book's cube has it.
std::optional<Vec3d> named_colour(std::string_view name);
/// The first name of exactly this colour.
std::optional<std::string_view> colour_name(const Vec3d& colour);

}  // namespace ps
