#pragma once
#include <string>

namespace ps::gui {

/// What a script expects of a value.
struct Expectation {
  std::string relation = "=";  ///< = != ~= < > contains
  std::string value;
  double tolerance = 1e-6;  ///< of ~=, relative to the expected value where that is above 1
};

/// = and != compare numerically where both are numbers ("0.50" is 0.5), else as text. ~= < > need numbers; they are
/// false for anything else.
bool fulfils(const std::string& found, const Expectation& expected);

/// What a name in a script refers to: something to click, or anything to read.
enum class Named { control, any };

/// "; similar: a, b, c" from the controls of the last frame, and from the published values if these will do; or "".
/// Says so if the name is that of a value where a control is wanted.
std::string similar_controls(const std::string& name, Named wanted);

}  // namespace ps::gui
