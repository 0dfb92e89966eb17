#pragma once
#include <string>

#include "math/vec.h"

namespace ps {

/// A number as people read it: four significant digits, infinity and NaN in words, never "-0".
std::string number_text(double value);
/// The shortest text that reads back as the same double.
std::string exact_number_text(double value);
/// "(0.5, 1, 2.25)"
std::string vector_text(const Vec2d& value);
std::string vector_text(const Vec3d& value);

}  // namespace ps
