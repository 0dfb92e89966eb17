#pragma once
#include <string>

#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// The ball in the upper right corner of a picture's area: it shows where the world's axes point, and a drag that
/// begins on it carries the camera around the scene, without a key that a window manager takes. A click on it picks the
/// pixel below.

/// Where it is in the window; empty where it is not shown: outside of exploring, where handles are switched off, while
/// the camera flies, and where there is too little room.
std::optional<Area> orbit_ball_area(const Session& session, const PicturesState& state, const Area& area);

/// Draws it, and makes it known to scripts as `name`.
void draw_orbit_ball(const Session& session, const PicturesState& state, const Area& area, const std::string& name,
                     bool hovered);

}  // namespace ps::gui
