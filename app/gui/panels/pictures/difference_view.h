#pragma once
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// One picture of what parts A and B, amplified, with how far they are apart by a metric. `title` is the row above it,
/// of one line or two.
void difference_view(Session& session, PicturesState& state, const Area& title, const Area& area);

}  // namespace ps::gui
