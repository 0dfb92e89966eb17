#include "gui/widgets/tick.h"

#include "gui/theme/theme.h"

namespace ps::gui {

void draw_tick(ImVec2 row, float height) {
  const float x = row.x + px(4), y = row.y + height / 2;
  const ImVec2 points[]{{x, y}, {x + px(4), y + px(4)}, {x + px(11), y - px(5)}};
  ImGui::GetWindowDrawList()->AddPolyline(points, 3, colour_u32(palette().right_mark), ImDrawFlags_None, px(2.5));
}

}  // namespace ps::gui
