#pragma once
#include "gui/input/actions.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// Actions of keys and menus on the pictures: how they are compared and zoomed, what they show, which pixel is picked,
/// where the camera is.
void add_picture_actions(Actions& actions, Session& session, PicturesState& pictures);

}  // namespace ps::gui
