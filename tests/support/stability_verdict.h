#pragma once
#include <span>
#include <string>
#include <vector>

#include "study/stability/experiment.h"
#include "support/stability_table.h"

namespace ps::test {

/// The measured rows that a row of the table is about, in the order of their knobs, without those that lack its method.
std::vector<StabilityRow> rows_about(const StabilityFigure& figure, std::span<const StabilityRow> measured);

/// Why the measured rows do not keep to a row of the table; "" if they do. A row of kind `not_reached` is kept to as
/// long as its figure does not come out.
std::string fault_of(const StabilityFigure& figure, std::span<const StabilityRow> measured);

/// A row of assets/gallery/stability.md reads page_row_start(), page_value(), page_row_end(). The value is "10.1" or
/// "0.97, 8.07, 27.4" of several knobs.
std::string page_row_start(const StabilityFigure& figure);
std::string page_value(const StabilityFigure& figure, std::span<const StabilityRow> measured);
std::string page_row_end(const StabilityFigure& figure);

}  // namespace ps::test
