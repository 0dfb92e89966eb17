#pragma once
#include <optional>
#include <vector>

#include "textbook/listing_view.h"

namespace ps::gui {

/// A loop whose arrow was clicked.
struct ListingStep {
  std::size_t row = 0;
  int by = 0;
};

/// Lines of code with the values beside them, or below where there is no room, in all the room that is left. `reveal`:
/// scrolls to the first line that has values.
std::optional<ListingStep> listing_code(const std::vector<ListingRow>& rows, bool reveal);

}  // namespace ps::gui
