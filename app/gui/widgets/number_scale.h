#pragma once
#include <optional>
#include <string_view>

#include "gui/widgets/widgets.h"

namespace ps::gui {

/// Where a value lies on its slider, in [0, 1]. On a logarithmic range that begins at 0, the first hundredth of the
/// slider is 0.
double slider_position(double value, const NumberRange& range);
/// The value at a position, rounded to three significant digits (whole for integers) and kept in the range.
double slider_value(double position, const NumberRange& range);
/// The next round value (1, 2 or 5 times a power of ten on a logarithmic range) `steps` steps up or down.
double stepped_value(double value, int steps, const NumberRange& range);
/// What a person typed, with blanks around it or not, whole for integers and kept in the range; nullopt if
/// parse_typed_number() takes it for no number.
std::optional<double> typed_value(std::string_view text, const NumberRange& range);

}  // namespace ps::gui
