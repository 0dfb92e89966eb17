#pragma once
#include "gui/panels/space/space_panel.h"

namespace ps::gui {

/// The mouse on the gizmos of the space view: those of the picked object and, unless one looks through it, of the
/// picture's camera. Call right after the view's invisible button, whose place is `area`.
void space_gizmo_input(Session& session, SpacePanelState& state, const PicturesState& pictures, const Area& area);

/// Draws them and makes them known to scripts as "object/move/x" and "camera/turn/up".
void draw_space_gizmos(const Session& session, const SpacePanelState& state, const PicturesState& pictures,
                       const Area& area);

}  // namespace ps::gui
