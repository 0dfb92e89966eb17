#pragma once
#include "gui/panels/pictures/difference_scale.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// One picture of what parts A and B, amplified, with its scale beside or below it and how far A and B are apart by a
/// metric. `title` is the row above it, of one line or two.
void difference_view(Session& session, PicturesState& state, const Area& title, const DifferencePlaces& places);

}  // namespace ps::gui
