#pragma once
#include "gui/panels/pictures/picture_transform.h"
#include "inspect/microscope/drawing.h"

namespace ps::gui {

/// Where a point of a drawing is in the window, and back. The drawing fills the area.
ImVec2 micro_place(const MicroDrawing& drawing, const Area& area, const Vec2d& point);
Vec2d micro_point(const MicroDrawing& drawing, const Area& area, ImVec2 place);

/// Paints a drawing of the microscope over its backdrop.
void draw_micro(ImDrawList& list, const MicroDrawing& drawing, const Area& area, ImTextureID backdrop);

}  // namespace ps::gui
