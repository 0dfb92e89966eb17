#pragma once
#include <optional>
#include <vector>

#include "gui/panels/story/listing_marks.h"
#include "textbook/listing_view.h"

namespace ps::gui {

/// A click on the arrow of a loop, or on a value.
struct ListingStep {
  std::size_t row = 0;
  int by = 0;
  int watch = -1;  ///< of the value: its place in the trace
  int component = -1;
};

/// Lines of code with the values beside them, or below where there is no room, in all the room that is left. `reveal`:
/// scrolls to the marked line, else to the first one that has values, with the head of its routine in sight where both
/// fit.
std::optional<ListingStep> listing_code(const std::vector<ListingRow>& rows, bool reveal, const LineMarks& marks = {});

}  // namespace ps::gui
