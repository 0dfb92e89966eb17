#include "gui/panels/pictures/marks.h"

#include <algorithm>

#include "gui/widgets/draw.h"

namespace ps::gui {

void name_plate(ImDrawList& list, const std::string& text, ImVec2 at, double away, const Area& clip) {
  const FontScope font(Face::body);
  const ImVec2 extent{text_width(text), text_height(text)};
  const float pad = px(6), aside = px(away);
  ImVec2 low{at.x + aside, at.y - extent.y / 2 - pad};
  if (low.x + extent.x + 2 * pad > clip.max.x) low.x = at.x - aside - extent.x - 2 * pad;
  low.x = std::max(low.x, clip.min.x);
  list.AddRectFilled(low, {low.x + extent.x + 2 * pad, low.y + extent.y + 2 * pad}, colour_u32(palette().panel, 0.94f),
                     px(4));
  draw_lines({low.x + pad, low.y + pad}, text, palette().text);
}

}  // namespace ps::gui
