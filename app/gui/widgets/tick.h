#pragma once
#include <imgui.h>

namespace ps::gui {

/// The sign of what is done, at the left end of a row of this height.
void draw_tick(ImVec2 row, float height);

}  // namespace ps::gui
