#pragma once
#include "gui/panels/studies/chart_tab.h"

namespace ps::gui {

/// Shown in place of a chart that is not measured yet: its axes without numbers, which corner is the best, and
/// the points that will be measured, with the marks that they will have. `button` is what begins it;
/// `measuring`: that was done.
void chart_invitation(const ChartTab& tab, const Area& area, std::string_view button, bool measuring);

}  // namespace ps::gui
