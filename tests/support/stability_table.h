#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ps::test {

/// What kind of set-up a row of the table is about.
enum class FigureKind {
  reproduced,   ///< another measurement describes its set-up completely, and its figure comes out
  ours,         ///< an illustration of our own, held to what is true of any such scene
  not_reached,  ///< the figure of another measurement does not come out; the remark says why
  reference     ///< not measured: a formula or a constant that an experiment prints beside what it measures
};

/// What a row asserts of the measured value, or of the values at several knobs.
enum class FigureRule {
  given,       ///< the figure, within a factor of 1.5 or, where that is more, what chance allows for few counted events
  zero,        ///< exactly 0
  above_zero,  ///< more than 0
  magnitude,   ///< our own published figure, within a factor of 10
  closed_form,  ///< a figure that follows from a formula, within the allowance
  rising,       ///< no value is below the one at the next smaller knob, and the last is above the first
  falling,      ///< the opposite
  above_robust  ///< the naive value is above the robust one at each knob
};

enum class FigureMethod { naive, robust };

/// Closed interval.
struct FigureRange {
  double low = 0, high = 0;
  bool holds(double value) const { return low <= value && value <= high; }
};

/// One row of tests/property/stability_figures/*.tsv.
struct StabilityFigure {
  std::string experiment, series;
  std::string knob, figure, allowance, remark;  ///< as they are written
  FigureMethod method = FigureMethod::naive;
  FigureKind kind = FigureKind::ours;
  FigureRule rule = FigureRule::zero;
  std::string place;    ///< "rays.tsv:12"
  FigureRange knobs;    ///< a single knob has low = high; "all" reaches from -infinity to infinity
  FigureRange accepts;  ///< measured values that the rule accepts; all for `rising`, `falling` and `above_robust`
};

/// All rows, files in the order of their names. Throws InputError with file and line for a row that cannot be read or
/// whose kind and rule do not go together.
std::vector<StabilityFigure> read_stability_figures();
/// The rows of the text of one file, whose `name` is used in messages.
std::vector<StabilityFigure> parse_stability_figures(std::string_view text, const std::string& name);

/// The means of Poisson distributions that give `events` or fewer, and `events` or more, at least as often as a normal
/// distribution lies more than three standard deviations to one side (0.135 %). The low end is above 0 from 1 event on.
/// Source: Garwood, Biometrika 28 (1936).
FigureRange poisson_interval(int events);

/// "reproduced", "ours", "not reached" or "reference".
std::string kind_text(FigureKind kind);

}  // namespace ps::test
