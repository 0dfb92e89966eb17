#pragma once
#include "gui/session/session.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {

/// Makes a step of what was done in the row of `side`: its value, the menu's commands, or what a grey row needs.
/// `settings` are the side's with the row's change. A sweep is left to the chart's panel.
void take_row_result(Session& session, Side side, const Option& option, const Settings& settings,
                     const OptionRowResult& result);

}  // namespace ps::gui
