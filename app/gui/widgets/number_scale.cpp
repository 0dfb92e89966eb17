#include "gui/widgets/number_scale.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"

namespace ps::gui {
namespace {

constexpr double zero_share = 0.01;  // of the slider
constexpr double decades = 8;        // below the maximum, on logarithmic ranges that begin at 0

double smallest(const NumberRange& range) {
  return range.minimum > 0 ? range.minimum
                           : std::max(range.integer ? 1.0 : 0.0, range.maximum * std::pow(10.0, -decades));
}

double round_digits(double value, int digits) {
  if (value == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1 - digits);
  // Dividing by a whole number keeps 0.001 the nearest double to 0.001.
  return unit >= 1 ? std::round(value / unit) * unit : std::round(value * std::round(1 / unit)) / std::round(1 / unit);
}

double keep_in(double value, const NumberRange& range) {
  if (range.integer) value = std::round(value);
  return std::clamp(value, range.minimum, range.maximum);
}

/// The largest of 1, 2, 5 times a power of ten that is not above `value`.
double round_down_125(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
  const double lead = value / power * (1 + 1e-9);
  return round_digits((lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power, 1);
}

double next_125(double value) {
  const double down = round_down_125(value);
  const double lead = std::round(down / std::pow(10.0, std::floor(std::log10(down) + 1e-9)));
  return round_digits(down * (lead == 2 ? 2.5 : 2), 1);
}

double previous_125(double value) {
  const double down = round_down_125(value);
  return down < value * (1 - 1e-9) ? down : round_down_125(down * 0.7);
}

}  // namespace

double slider_position(double value, const NumberRange& range) {
  if (range.maximum <= range.minimum) return 0;
  if (range.scale == OptionScale::linear)
    return std::clamp((value - range.minimum) / (range.maximum - range.minimum), 0.0, 1.0);
  const double first = smallest(range), start = range.minimum > 0 ? 0 : zero_share;
  if (value < first) return 0;
  return std::clamp(start + (1 - start) * std::log(value / first) / std::log(range.maximum / first), 0.0, 1.0);
}

double slider_value(double position, const NumberRange& range) {
  position = std::clamp(position, 0.0, 1.0);
  if (range.scale == OptionScale::linear) {
    const double span = range.maximum - range.minimum;
    double value = range.minimum + position * span;
    if (!range.integer) {
      const double unit = std::pow(10.0, std::floor(std::log10(span)) - 3);
      value = std::round(value / unit) / std::round(1 / unit > 1 ? 1 / unit : 1) * (unit > 1 ? unit : 1);
    }
    return keep_in(value, range);
  }
  const double first = smallest(range), start = range.minimum > 0 ? 0 : zero_share;
  if (position < start) return range.minimum;
  return keep_in(round_digits(first * std::pow(range.maximum / first, (position - start) / (1 - start)), 3), range);
}

double stepped_value(double value, int steps, const NumberRange& range) {
  for (int i = 0; i < std::abs(steps); ++i) {
    if (range.scale == OptionScale::logarithmic) {
      const double first = smallest(range);
      if (steps > 0)
        value = value < first ? first : std::max(next_125(value), range.integer ? std::floor(value) + 1 : 0.0);
      else
        value = value <= first ? range.minimum : previous_125(value);
    } else {
      const double unit = range.integer ? 1 : round_down_125((range.maximum - range.minimum) / 20);
      value = (std::round(value / unit) + (steps > 0 ? 1 : -1)) * unit;
      value = std::round(value * 1e9) / 1e9;
    }
    value = keep_in(value, range);
  }
  return value;
}

std::optional<double> typed_value(std::string_view text, const NumberRange& range) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  const auto value = parse_typed_number(text.substr(first, text.find_last_not_of(' ') + 1 - first));
  return value ? std::optional(keep_in(*value, range)) : std::nullopt;
}

}  // namespace ps::gui
