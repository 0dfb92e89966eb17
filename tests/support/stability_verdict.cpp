#include "support/stability_verdict.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ps::test {
namespace {

double value_of(const StabilityRow& row, FigureMethod method) {
  return method == FigureMethod::naive ? row.naive : row.robust;
}

/// Knobs are written with six digits or more.
bool about(const FigureRange& knobs, double knob) {
  return knob >= knobs.low - 1e-6 * std::abs(knobs.low) && knob <= knobs.high + 1e-6 * std::abs(knobs.high);
}

/// The sequence's first step in the wrong direction; "" if there is none. `sign` is 1 for a rising sequence.
std::string wrong_step(const std::vector<StabilityRow>& rows, FigureMethod method, double sign) {
  if (rows.size() < 2) return "one knob alone cannot rise or fall";
  const auto value = [&](std::size_t i) { return sign * value_of(rows[i], method); };
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (value(i) < value(i - 1))
      return fmt::format("{:.4g} at {:g}, but {:.4g} at {:g}", sign * value(i - 1), rows[i - 1].knob, sign * value(i),
                         rows[i].knob);
  return value(rows.size() - 1) > value(0) ? "" : "the first value is the last";
}

std::string method_text(FigureMethod method) { return method == FigureMethod::naive ? "naive" : "robust"; }

/// A bar in a name would begin a cell.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string held_to(const StabilityFigure& figure) {
  switch (figure.rule) {
  case FigureRule::given:
    if (figure.kind == FigureKind::not_reached) return figure.figure + " was given";
    return fmt::format("{} was given; {:.4g} to {:.4g}", figure.figure, figure.accepts.low, figure.accepts.high);
  case FigureRule::zero:
    return "exactly 0";
  case FigureRule::above_zero:
    return figure.figure.empty() ? "above 0" : fmt::format("above 0; {} over machines", figure.figure);
  case FigureRule::magnitude:
    return fmt::format("{}, within a factor of 10", figure.figure);
  case FigureRule::closed_form:
    if (figure.allowance.empty()) return "formula: " + figure.figure;
    return fmt::format("formula: {}, off by {} at most", figure.figure, figure.allowance);
  case FigureRule::rising:
    return "rises with the knob";
  case FigureRule::falling:
    return "falls with the knob";
  case FigureRule::above_robust:
    return "above the robust method";
  }
  return "";
}

}  // namespace

std::vector<StabilityRow> rows_about(const StabilityFigure& figure, std::span<const StabilityRow> measured) {
  std::vector<StabilityRow> rows;
  for (const StabilityRow& row : measured)
    if (row.series == figure.series && about(figure.knobs, row.knob) && !std::isnan(value_of(row, figure.method)))
      rows.push_back(row);
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.knob < b.knob; });
  return rows;
}

std::string fault_of(const StabilityFigure& figure, std::span<const StabilityRow> measured) {
  const std::vector<StabilityRow> rows = rows_about(figure, measured);
  if (rows.empty()) return "nothing is measured there";
  switch (figure.rule) {
  case FigureRule::rising:
    return wrong_step(rows, figure.method, 1);
  case FigureRule::falling:
    return wrong_step(rows, figure.method, -1);
  case FigureRule::above_robust:
    for (const StabilityRow& row : rows)
      if (!(row.naive > row.robust))
        return fmt::format("naive {:.4g} is not above robust {:.4g} at {:g}", row.naive, row.robust, row.knob);
    return "";
  case FigureRule::given:
  case FigureRule::zero:
  case FigureRule::above_zero:
  case FigureRule::magnitude:
  case FigureRule::closed_form:
    break;
  }
  for (const StabilityRow& row : rows) {
    const double value = value_of(row, figure.method);
    const bool reached = figure.accepts.holds(value);
    if (figure.kind == FigureKind::not_reached && reached)
      return fmt::format("{:.6g} comes out now: the row's kind is reproduced", value);
    if (figure.kind != FigureKind::not_reached && !reached)
      return fmt::format("{:.6g} is not within {:.6g} to {:.6g}", value, figure.accepts.low, figure.accepts.high);
  }
  return "";
}

std::string page_row_start(const StabilityFigure& figure) {
  return fmt::format("| {} | {} | {} | {} | ", figure.experiment, cell(figure.series), figure.knob,
                     method_text(figure.method));
}

std::string page_value(const StabilityFigure& figure, std::span<const StabilityRow> measured) {
  std::string text;
  for (const StabilityRow& row : rows_about(figure, measured))
    text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", value_of(row, figure.method));
  return text;
}

std::string page_row_end(const StabilityFigure& figure) {
  return fmt::format(" | {} | {} | {} |", kind_text(figure.kind), held_to(figure), cell(figure.remark));
}

}  // namespace ps::test
