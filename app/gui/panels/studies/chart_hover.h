#pragma once
#include "gui/panels/studies/chart_tab.h"

namespace ps::gui {

/// The tooltip of a point: its numbers, its picture and how that differs from the reference.
/// `hint` is below.
void chart_hover(const ChartTab& tab, const ChartPoint& point, ChartPreview& preview, const char* hint);

}  // namespace ps::gui
