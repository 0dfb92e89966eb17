#pragma once
#include "gui/input/actions.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// Actions for the size in which both pictures are rendered. The picked pixel keeps its place in the picture.
void add_size_actions(Actions& actions, Session& session, PicturesState& pictures);

/// Fields for width and height, for a menu.
void size_fields(Session& session);

}  // namespace ps::gui
