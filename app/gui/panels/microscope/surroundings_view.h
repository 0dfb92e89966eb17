#pragma once
#include <optional>

#include "gui/session/session.h"
#include "inspect/microscope/surroundings.h"

namespace ps::gui {

/// The surroundings of a pixel without edges, with a button that goes to the nearest edge.
void surroundings_view(Session& session, const PixelSurroundings& surroundings, Vec2i pixel);

}  // namespace ps::gui
