#pragma once
#include "gui/panels/pictures/picture_transform.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The bar above the pictures: each technique as a switch or a row of choices, the way back from the comparison, and
/// the way to all options. One click is one comparison.
/// Its height in this width, window pixels.
float technique_bar_height(float width);
void technique_bar(Session& session, const Area& area);

}  // namespace ps::gui
