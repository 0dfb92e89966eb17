#include "study/stability/figures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "base/csv.h"

namespace ps {
namespace {

constexpr double rounding_share = 1e-9;

struct SeriesRows {
  std::string name;
  int order = 0;
  const StabilitySeries* quantity = nullptr;
  std::vector<const StabilityRow*> rows;
};

/// The series as they are to be shown, each with its rows.
std::vector<SeriesRows> in_order(const StabilityExperiment& experiment, std::span<const StabilityRow> rows) {
  std::vector<SeriesRows> all;
  for (const StabilityRow& row : rows) {
    auto found = std::find_if(all.begin(), all.end(), [&](const SeriesRows& one) { return one.name == row.series; });
    if (found == all.end()) {
      all.push_back({row.series, series_order(experiment, row.series), &quantity_of(experiment, row.series), {}});
      found = all.end() - 1;
    }
    found->rows.push_back(&row);
  }
  std::stable_sort(all.begin(), all.end(), [](const SeriesRows& a, const SeriesRows& b) { return a.order < b.order; });
  return all;
}

bool is_bars(const SeriesRows& series) { return !series.quantity->cases.empty() || series.rows.size() == 1; }

ExperimentFigure::Row figure_row(const SeriesRows& series, const StabilityRow& row, std::string name) {
  return {std::move(name), series.name, row.knob, row.naive, row.robust};
}

ExperimentFigure curve_of(const SeriesRows& series) {
  ExperimentFigure figure{series.name, FigureForm::curve, series.quantity, {}};
  for (const StabilityRow* row : series.rows) figure.rows.push_back(figure_row(series, *row, ""));
  std::stable_sort(figure.rows.begin(), figure.rows.end(),
                   [](const auto& a, const auto& b) { return a.knob < b.knob; });
  return figure;
}

/// All bars of a quantity. `alone`: it has a single series, whose name need not be at each of them.
ExperimentFigure bars_of(const std::vector<const SeriesRows*>& parts) {
  const StabilitySeries& quantity = *parts.front()->quantity;
  ExperimentFigure figure{
      parts.size() == 1 ? parts.front()->name : std::string(quantity.title), FigureForm::bars, &quantity, {}};
  for (const SeriesRows* part : parts)
    for (const StabilityRow* row : part->rows) {
      const std::string_view value = case_name(quantity, row->knob);
      std::string name = value.empty()       ? part->name
                         : parts.size() == 1 ? std::string(value)
                                             : fmt::format("{}, {}", part->name, value);
      figure.rows.push_back(figure_row(*part, *row, std::move(name)));
    }
  return figure;
}

}  // namespace

std::string ExperimentFigure::axis_title() const {
  const std::string_view better = better_text(quantity->better);
  return fmt::format("{} ({}){}{}", quantity->title, quantity->unit, better.empty() ? "" : ", ", better);
}

std::vector<ExperimentFigure> experiment_figures(const StabilityExperiment& experiment,
                                                 std::span<const StabilityRow> rows) {
  const std::vector<SeriesRows> all = in_order(experiment, rows);
  std::vector<ExperimentFigure> figures;
  std::vector<const StabilitySeries*> with_bars;
  for (const SeriesRows& series : all) {
    if (!is_bars(series)) {
      figures.push_back(curve_of(series));
      continue;
    }
    if (std::find(with_bars.begin(), with_bars.end(), series.quantity) != with_bars.end()) continue;
    with_bars.push_back(series.quantity);
    std::vector<const SeriesRows*> parts;
    for (const SeriesRows& other : all)
      if (other.quantity == series.quantity && is_bars(other)) parts.push_back(&other);
    figures.push_back(bars_of(parts));
  }
  return figures;
}

std::string_view knob_title(const StabilityExperiment& experiment, const StabilitySeries& quantity) {
  return quantity.knob.empty() ? experiment.knob : quantity.knob;
}

std::string_view naive_name(const StabilityExperiment& experiment, const StabilitySeries& quantity) {
  return quantity.naive.empty() ? experiment.naive : quantity.naive;
}

std::string_view robust_name(const StabilityExperiment& experiment, const StabilitySeries& quantity) {
  return quantity.robust.empty() ? experiment.robust : quantity.robust;
}

std::optional<ExperimentFigure::Row> worst_row(const ExperimentFigure& figure) {
  if (figure.quantity->better == Better::neither) return {};
  const auto worse = [&](double a, double b) { return figure.quantity->better == Better::lower ? a > b : a < b; };
  std::optional<ExperimentFigure::Row> worst;
  for (const ExperimentFigure::Row& row : figure.rows)
    if (!std::isnan(row.naive) && (!worst || worse(row.naive, worst->naive))) worst = row;
  return worst;
}

std::string result_text(double value, double scale) {
  if (value == 0) return "0";
  if (std::isinf(value)) return value > 0 ? "infinite" : "-infinite";
  if (std::isfinite(scale) && std::abs(value) < rounding_share * std::abs(scale)) return "rounding only";
  const double size = std::abs(value);
  if (size >= 1000 && size < 1e6) return fmt::format("{:.0f}", value);
  return fmt::format("{:.3g}", value);
}

std::string first_figure_text(const StabilityExperiment& experiment, std::span<const StabilityRow> rows) {
  const std::vector<ExperimentFigure> figures = experiment_figures(experiment, rows);
  if (figures.empty()) return "";
  const ExperimentFigure& first = figures.front();
  const std::string_view better = better_text(first.quantity->better);
  const std::string name = first.name == first.quantity->title ? "" : first.name + ": ";
  return fmt::format("Shown first, {}{}, in {}{}{}.", name, first.quantity->title, first.quantity->unit,
                     better.empty() ? "" : "; ", better);
}

std::string stability_csv_with_meaning(std::string_view csv, const StabilityExperiment& experiment,
                                       std::span<const StabilityRow> rows) {
  const std::vector<std::string> heading{"quantity", "quantity_unit", "better", "knob_title", "knob_name"};
  return csv_with_columns(csv, heading, [&](std::size_t i) {
    PS_ASSERT(i < rows.size(), "each line of the table is a row");
    const StabilitySeries& quantity = quantity_of(experiment, rows[i].series);
    return std::vector<std::string>{
        std::string(quantity.title), std::string(quantity.unit), std::string(better_key(quantity.better)),
        std::string(knob_title(experiment, quantity)), std::string(case_name(quantity, rows[i].knob))};
  });
}

}  // namespace ps
