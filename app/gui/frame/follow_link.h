#pragma once
#include "gui/panels/panel.h"

namespace ps::gui {

/// Does what a clicked link of a lesson's text asks of the window: shows the control or the panel and lights it up.
/// Panels take links to what is theirs.
void follow_link(const PanelHost& host, const LinkTarget& target);

}  // namespace ps::gui
