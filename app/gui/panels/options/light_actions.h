#pragma once
#include "gui/input/actions.h"
#include "gui/panels/options/options_panel.h"

namespace ps::gui {

/// The keys that move the selected light.
void add_light_actions(Actions& actions, Session& session, OptionsPanelState& state);

}  // namespace ps::gui
