#pragma once
#include <optional>
#include <string>

#include "gui/panels/pictures/picture_view.h"
#include "image/difference.h"

namespace ps::gui {

/// "12 levels", "31 %", "0.42": a value of the map of a difference, with its unit.
std::string difference_value_text(double value, DifferenceMode mode);

/// The map in words: the 99.9th percentile, the largest value and where, the share of pixels that differ.
std::string difference_numbers_text(const DifferenceNumbers& numbers, DifferenceMode mode);

/// Where the map of a difference and its scale are in a place: the scale beside the picture or below it, whichever
/// leaves the picture larger, and never over it. Where it would cost the picture too much there is none.
struct DifferencePlaces {
  Area picture;
  std::optional<Area> scale;
};
DifferencePlaces difference_places(const Area& place, Vec2i picture_size);

/// The colours of the map with the values at both ends, and the numbers below, from the upper left corner of an area.
void draw_difference_scale(ImDrawList& list, const DifferenceOptions& options, const DifferenceNumbers& numbers,
                           const Area& area);

}  // namespace ps::gui
