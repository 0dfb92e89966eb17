#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/stability/experiment.h"

namespace ps {

/// How the rows of a figure are drawn.
enum class FigureForm {
  curve,  ///< over the knob
  bars,   ///< one under the other, each with its name
};

/// What is drawn of an experiment at a time: one quantity.
struct ExperimentFigure {
  struct Row {
    std::string name;                        ///< of a bar: "float, at edges"
    std::string series;                      ///< of the table
    double knob = 0, naive = 0, robust = 0;  ///< a method that does not exist is NaN
  };
  std::string name;  ///< in a list of the experiment's figures: the series, or the quantity of several bars
  FigureForm form = FigureForm::curve;
  const StabilitySeries* quantity = nullptr;
  std::vector<Row> rows;  ///< a curve by the knob, bars in the order of the table

  std::string axis_title() const;  ///< "lit pixels in their own shadow (%), lower is better"
};

/// The figures of what is measured so far, the one first that the text describes. Series whose knob is not a quantity,
/// and those of a single place, are bars together with the others of their quantity.
std::vector<ExperimentFigure> experiment_figures(const StabilityExperiment& experiment,
                                                 std::span<const StabilityRow> rows);

/// The title of a figure's horizontal axis.
std::string_view knob_title(const StabilityExperiment& experiment, const StabilitySeries& quantity);
/// The two methods of a figure.
std::string_view naive_name(const StabilityExperiment& experiment, const StabilitySeries& quantity);
std::string_view robust_name(const StabilityExperiment& experiment, const StabilitySeries& quantity);

/// The row in which the naive method does worst, by the direction of the quantity. nullopt where it has no direction or
/// no naive method.
std::optional<ExperimentFigure::Row> worst_row(const ExperimentFigure& figure);

/// A result for people: three digits, or "rounding only" where it is not 0 but less than a billionth of `scale`, the
/// size of what it is beside.
std::string result_text(double value, double scale);

/// "The first figure shows radius 5000, float: lit pixels in their own shadow, in %; lower is better."
std::string first_figure_text(const StabilityExperiment& experiment, std::span<const StabilityRow> rows);

/// A table that begins with stability_csv() of the same rows, with what each row means behind its columns: quantity,
/// quantity_unit, better ("lower", "higher" or "neither"), knob_title, and knob_name where the knob is not a
/// quantity.
std::string stability_csv_with_meaning(std::string_view csv, const StabilityExperiment& experiment,
                                       std::span<const StabilityRow> rows);

}  // namespace ps
