#pragma once
#include "gui/panels/pictures/picture_transform.h"
#include "gui/panels/pictures/slow_motion.h"

namespace ps::gui {

/// The height of the strip below the pictures; 0 while slow motion is closed.
float slow_strip_height(const Session& session);

/// The scrubber with its buttons, and what each picture counts. Drawn into the region that has been begun for it.
void slow_strip(Session& session, SlowMotionState& state);

/// Marks in a picture what was drawn last: the triangle's outline, the pixel, row or tile.
void slow_mark(ImDrawList& list, const SlowState& state, const PictureTransform& transform, const Area& area);

}  // namespace ps::gui
