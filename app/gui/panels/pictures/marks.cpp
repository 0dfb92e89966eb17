#include "gui/panels/pictures/marks.h"

#include <cfloat>

namespace ps::gui {

void name_plate(ImDrawList& list, const std::string& text, ImVec2 at, double away, const Area& clip) {
  ImFont* font = theme().font(Face::body);
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
  const float pad = px(6), aside = px(away);
  ImVec2 low{at.x + aside, at.y - extent.y / 2 - pad};
  if (low.x + extent.x + 2 * pad > clip.max.x) low.x = at.x - aside - extent.x - 2 * pad;
  list.AddRectFilled(low, {low.x + extent.x + 2 * pad, low.y + extent.y + 2 * pad}, colour_u32(palette().panel, 0.94f),
                     px(4));
  list.AddText(font, font->FontSize, {low.x + pad, low.y + pad}, colour_u32(palette().text), text.c_str());
}

}  // namespace ps::gui
