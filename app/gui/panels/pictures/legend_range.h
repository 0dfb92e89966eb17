#pragma once
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// The width that the handles and fields of a scale need, at scale 1.
inline constexpr double range_width = 236;

/// The range of a side's false colours, over the legend's bar and in the row below it: two handles, a field for each
/// end, and a button back to the range of the pictures' values. Draws the bar.
void legend_range(Session& session, PicturesState& state, Side side, const ChannelLegend& legend,
                  const LegendScale& scale);

}  // namespace ps::gui
