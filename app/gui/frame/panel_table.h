#pragma once
#include <string_view>
#include <vector>

#include "gui/frame/panel_states.h"
#include "gui/panels/panel.h"

namespace ps::gui {

/// All panels with their texts, in the order in which they are listed. What they are given must outlive them.
std::vector<Panel> panel_table(Session& session, PanelStates& states, const PanelHost& host);

/// The panel of that name, else the first of those below the pictures.
const Panel& find_panel(const std::vector<Panel>& panels, std::string_view name);

}  // namespace ps::gui
