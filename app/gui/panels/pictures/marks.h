#pragma once
#include <imgui.h>

#include <string>

#include "gui/panels/pictures/picture_transform.h"
#include "gui/theme/theme.h"

/// Marks that are visible on a picture of any colour, for all that can be dragged in it.
namespace ps::gui {

/// Draws light on dark: calls `stroke(colour, thickness)` for both.
template <class Stroke>
void light_on_dark(bool held, Stroke&& stroke, ImU32 light = IM_COL32(255, 255, 255, 255)) {
  stroke(IM_COL32(0, 0, 0, 190), px(held ? 6 : 3.5));
  stroke(light, px(held ? 3.5 : 1.5));
}

/// A name beside a mark, `away` window pixels at scale 1 from its centre, on the side that has room in `clip`.
void name_plate(ImDrawList& list, const std::string& text, ImVec2 at, double away, const Area& clip);

}  // namespace ps::gui
