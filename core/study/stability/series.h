#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ps {

/// Which values of a measured quantity are the good ones.
enum class Better {
  lower,
  higher,
  neither,  ///< a value to compare with, such as a level that is shown
};
/// "lower is better", "higher is better", or "" where neither is.
std::string_view better_text(Better better);
/// "lower", "higher", "neither": in files.
std::string_view better_key(Better better);

/// What a value of a knob means where it is not a quantity: 32 is float.
struct KnobCase {
  double knob = 0;
  std::string_view name;
};

/// Whether something lies between two values of a knob.
enum class Between {
  values,   ///< any value could be set: neighbours are joined by a line
  nothing,  ///< the values are all there are, or what lies between is not between in its result
};

/// Series of an experiment that measure the same quantity.
struct StabilitySeries {
  /// Patterns of the names of series, with '*' for any text and '|' between alternatives. The pattern with the most
  /// letters beside its '*' takes a series. The first alternative is shown first.
  std::string_view names;
  std::string_view title;  ///< the quantity, as the title of an axis: "lit pixels in their own shadow"
  std::string_view unit;   ///< "%"
  Better better = Better::lower;
  std::string_view knob{};        ///< if it is another than the experiment's: title and unit
  std::vector<KnobCase> cases{};  ///< all values of the knob, if they are not quantities
  Between between = Between::values;
  std::string_view naive{}, robust{};  ///< the two methods, if they are others than the experiment's
};

struct StabilityExperiment;

/// The declaration that a series belongs to. Every series of a table has one.
const StabilitySeries& quantity_of(const StabilityExperiment& experiment, std::string_view series);
/// Where a series is among those of its experiment: the declarations in their order, in each its alternatives.
int series_order(const StabilityExperiment& experiment, std::string_view series);
/// The name of a knob's value, or nothing if it is a quantity.
std::string_view case_name(const StabilitySeries& quantity, double knob);

}  // namespace ps
