#pragma once
#include "gui/panels/studies/chart_tab.h"

namespace ps::gui {

/// The height of the row of pictures in an area that it shares with the plot; 0 where the plot needs all of it.
float chart_strip_height(const Area& area);

/// The pictures of the measured points in the order of the sweep, each with what sets it apart, its share of the first
/// one's cost and its error.
void draw_chart_strip(ChartTab& tab, const Area& area);

}  // namespace ps::gui
