#pragma once
#include <string>

#include "gui/panels/pictures/gizmo_view.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// The gizmo of the picked object as a side's picture shows it; nullopt while it is switched off or none is picked.
std::optional<ShownGizmo> gizmo_in_picture(const Session& session, const PicturesState& state, Side side,
                                           const Area& area);

/// Takes hold of the part of the gizmo under a point of the window, if there is one.
std::optional<GizmoDrag> take_gizmo(const Session& session, const PicturesState& state, Side side, const Area& area,
                                    ImVec2 point);

/// Draws the gizmo into `clip`, the part of the area that shows this side, and makes it known to scripts.
void picture_gizmo(const Session& session, const PicturesState& state, Side side, const Area& area, const Area& clip,
                   const std::string& prefix, bool hovered);

/// Takes back what the drag that goes on has changed and ends it. Answers whether one went on.
bool cancel_picture_drag(Session& session, PicturesState& state);

}  // namespace ps::gui
