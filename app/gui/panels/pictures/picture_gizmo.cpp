#include "gui/panels/pictures/picture_gizmo.h"

namespace ps::gui {

std::optional<ShownGizmo> gizmo_in_picture(const Session& session, const PicturesState& state, Side side,
                                           const Area& area) {
  const auto object = state.selection.object.index(session);
  if (!state.selection.gizmo || !object || flying(state)) return {};
  const auto gizmo = gizmo_of(session.scene(), *object);
  if (!gizmo) return {};
  return shown_gizmo(
      *gizmo, {session.view(), session.settings(side)},
      {[&](const Vec2d& place) { return state.drawn.transform.to_window(place, area); }, state.drawn.transform.zoom});
}

std::optional<GizmoDrag> take_gizmo(const Session& session, const PicturesState& state, Side side, const Area& area,
                                    ImVec2 point) {
  const auto shown = gizmo_in_picture(session, state, side, area);
  const GizmoMark* mark = shown ? mark_at(*shown, point) : nullptr;
  if (!mark) return {};
  return GizmoDrag{shown->gizmo,
                   mark->part,
                   {session.view(), session.settings(side)},
                   state.drawn.transform.to_picture(point, area),
                   shown->reach,
                   session.scene(),
                   session.view().camera};
}

void picture_gizmo(const Session& session, const PicturesState& state, Side side, const Area& area, const Area& clip,
                   const std::string& prefix, bool hovered) {
  const auto shown = gizmo_in_picture(session, state, side, area);
  if (!shown) return;
  std::optional<GizmoPart> held;
  if (state.mouse.drag == PictureDrag::gizmo) {
    if (state.mouse.drag_side == side) held = state.mouse.gizmo_drag->part;
  } else if (const ImVec2 mouse = ImGui::GetIO().MousePos; hovered && clip.contains(mouse)) {
    if (const GizmoMark* mark = mark_at(*shown, mouse)) held = mark->part;
  }
  if (held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  draw_gizmo(*ImGui::GetWindowDrawList(), *shown, held, clip);
  record_gizmo(prefix + "/gizmo", *shown, clip);
}

bool cancel_picture_drag(Session& session, PicturesState& state) {
  switch (state.mouse.drag) {
  case PictureDrag::gizmo:
    session.cancel_drag(gizmo_step);
    break;
  case PictureDrag::handle:
    session.cancel_drag(state.mouse.grabbed->path);
    break;
  case PictureDrag::look:
    session.cancel_drag("look");
    break;
  case PictureDrag::orbit:
    session.cancel_drag("orbit");
    break;
  case PictureDrag::none:
  case PictureDrag::undecided:
  case PictureDrag::pan:
  case PictureDrag::divider:
  case PictureDrag::region:
    return false;
  }
  state.mouse.drag = PictureDrag::none;
  return true;
}

}  // namespace ps::gui
