#pragma once
#include "gui/panels/panel.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// Actions of keys and menus on files, the clipboard and the history, and those of the mouse, for the help sheet.
/// `host` and the others must outlive the actions.
void add_window_actions(Actions& actions, Session& session, const PicturesState& pictures, const PanelHost& host);

}  // namespace ps::gui
