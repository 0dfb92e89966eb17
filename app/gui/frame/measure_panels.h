#pragma once
#include <vector>

#include "gui/frame/panel_states.h"
#include "gui/panels/panel.h"

namespace ps::gui {

/// The rows of panel_table() that measure: the studies of speed, accuracy and stability. What they are given must
/// outlive them.
std::vector<Panel> measure_panels(Session& session, PanelStates& states, const PanelHost& host);

}  // namespace ps::gui
