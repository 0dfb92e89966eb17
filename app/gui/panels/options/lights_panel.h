#pragma once
#include "gui/session/session.h"

namespace ps::gui {

/// The light that keys move: `wanted` if it is a point or directional light, else the first of those; the number of
/// lights if there is none.
int selected_light(const Scene& scene, int wanted);

/// The lights of the scene with their brightness; the one that keys move is marked, and shows its colours and size.
void lights_panel(Session& session, int& selected, bool& open);

}  // namespace ps::gui
