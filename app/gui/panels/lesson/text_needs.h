#pragma once
#include <vector>

#include "gui/panels/lesson/text_layout.h"
#include "gui/session/session.h"

namespace ps::gui {

/// Adds lines below a block for the live controls in it that cannot act: what they need, with a button that sets it,
/// as rows of the options panel have them. Where A and B need the same, both have one line.
void lay_out_needs(const TextBlock& block, const Session& session, float width, std::vector<TextLine>& lines);

/// Draws such a line at the cursor, and does what its button says.
void draw_need(Session& session, const ControlNeed& need, float width);

}  // namespace ps::gui
