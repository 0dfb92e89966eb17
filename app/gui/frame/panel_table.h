#pragma once
#include <string_view>
#include <vector>

#include "gui/frame/panel_states.h"
#include "gui/panels/panel.h"

namespace ps::gui {

/// The panel that takes the place of the options while it is open. No document keeps it, so it has no name there.
inline constexpr std::string_view history_panel_name = "history";

/// All panels with their texts, in the order in which they are listed. What they are given must outlive them.
std::vector<Panel> panel_table(Session& session, PanelStates& states, const PanelHost& host);

/// The panel of that name, else the first of those below the pictures.
const Panel& find_panel(const std::vector<Panel>& panels, std::string_view name);

}  // namespace ps::gui
