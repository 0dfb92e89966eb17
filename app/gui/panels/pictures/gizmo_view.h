#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gui/panels/pictures/picture_transform.h"
#include "gui/session/gizmo.h"

namespace ps::gui {

/// One part of a gizmo in the window.
struct GizmoMark {
  GizmoPart part;
  ImVec2 grip;               ///< an arrow's tip, a square, a place on a ring
  std::vector<ImVec2> line;  ///< the arrow's shaft or the ring; a square has none
};

/// A gizmo in the window. Parts that point at the eye, where a drag has no direction, are left out.
struct ShownGizmo {
  Gizmo gizmo;
  double reach = 1;  ///< length of the arrows, world units
  std::vector<GizmoMark> marks;
};

/// Length of a gizmo's arrows at scale 1, where there is room.
inline constexpr double gizmo_arrow = 74;

/// From a place of the picture to a point of the window, whose pixels are `zoom` times smaller than the picture's.
struct PictureToWindow {
  std::function<ImVec2(const Vec2d&)> point;
  double zoom = 1;
  double arrow = gizmo_arrow;  ///< length of the arrows, at scale 1
};

/// The gizmo at a size that is the same at any depth; nullopt behind the camera.
std::optional<ShownGizmo> shown_gizmo(const Gizmo& gizmo, const Sight& sight, const PictureToWindow& to_window);

/// The part of the gizmo at a point of the window, if one is near enough to be taken.
const GizmoMark* mark_at(const ShownGizmo& shown, ImVec2 point);

/// All parts, the one that is held or under the pointer thick and with its name.
void draw_gizmo(ImDrawList& list, const ShownGizmo& shown, const std::optional<GizmoPart>& held, const Area& clip);

/// "move/x", "turn/up": how scripts name a part.
std::string part_key(const Gizmo& gizmo, GizmoPart part);

/// Makes the parts within `clip` known to scripts as PREFIX/move/x.
void record_gizmo(const std::string& prefix, const ShownGizmo& shown, const Area& clip);

}  // namespace ps::gui
