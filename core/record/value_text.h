#pragma once
#include <span>
#include <string>
#include <vector>

#include "math/vec.h"

namespace ps {

/// A number as people read it: four significant digits, infinity and NaN in words, never "-0".
std::string number_text(double value);
/// Numbers that are in one row, four significant digits each, all of them with an exponent or none.
std::vector<std::string> number_row(std::span<const double> values);
/// The shortest text that reads back as the same double.
std::string exact_number_text(double value);
/// Both sides of a comparison: "2 against 1.5", with enough digits to show a difference; "7.25 against the same".
std::string against_text(double value, double other);
/// "(0.5, 1, 2.25)"
std::string vector_text(const Vec2d& value);
std::string vector_text(const Vec3d& value);

}  // namespace ps
