#pragma once
#include <functional>

#include "gui/frame/panel_states.h"

namespace ps::gui {

/// Does what a clicked link of a lesson's text asks for: shows the control or the panel and lights it up, or goes to
/// the step. `show_options` opens the options panel.
void follow_link(Session& session, PanelStates& states, const LinkTarget& target,
                 const std::function<void()>& show_options);

}  // namespace ps::gui
