#pragma once
#include <optional>
#include <string>
#include <vector>

namespace ps {

enum class AxisScale { linear, logarithmic };

/// A labelled position on an axis.
struct Tick {
  double value = 0;
  std::string text;  ///< empty for a small tick between labelled ones
};

/// One axis of a chart: maps values to [0, 1]. On a logarithmic axis, values that are zero or negative are on a place
/// of their own at the lower end, labelled "0" (an error of 0 is a result, and often the best).
struct PlotAxis {
  AxisScale scale = AxisScale::linear;
  double low = 0, high = 1;
  bool zero_place = false;
  bool whole = false;  ///< all values are whole numbers: on a linear axis no other is labelled

  /// Position of a value; outside values are clamped.
  double place(double value) const;
  std::vector<Tick> ticks() const;
  /// Where the axis is broken, between the place of zero and the smallest value; nullopt if it is whole.
  std::optional<double> break_place() const;
};

/// An axis that holds all finite values with some room at both ends.
PlotAxis fit_axis(const std::vector<double>& values, AxisScale scale);

/// Six significant digits without a useless tail: "0.001", "12.5", "10000", "1e-06".
std::string tick_text(double value);

}  // namespace ps
