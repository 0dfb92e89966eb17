#include "gui/panels/space/space_gizmos.h"

#include <algorithm>

#include "gui/base/record.h"
#include "gui/panels/pictures/gizmo_view.h"

namespace ps::gui {
namespace {

constexpr double room_share = 0.3;  // of the view, for an arrow

/// The sight of the view that is on the screen, which may be a frame older than the document.
Sight sight_of(const SpacePanelState& state) { return {state.picture->view, {}}; }

std::vector<ShownGizmo> gizmos_in_space(const Session& session, const SpacePanelState& state,
                                        const PicturesState& pictures, const Area& area) {
  std::vector<ShownGizmo> all;
  if (!pictures.selection.gizmo || !state.picture) return all;
  PictureToWindow to_window;
  to_window.point = [&](const Vec2d& place) {
    return ImVec2{area.min.x + static_cast<float>(place.x), area.min.y + static_cast<float>(place.y)};
  };
  const float room = std::min(area.width(), area.height()) / px(1);
  to_window.arrow = std::min(gizmo_arrow, room_share * static_cast<double>(room));
  const auto add = [&](const Gizmo& gizmo) {
    if (auto shown = shown_gizmo(gizmo, sight_of(state), to_window)) all.push_back(std::move(*shown));
  };
  if (const auto object = pictures.selection.object.index(session))
    if (const auto gizmo = gizmo_of(session.scene(), *object)) add(*gizmo);
  if (!session.document().story.outside.through_camera) add(gizmo_of(session.view().camera));
  return all;
}

struct UnderPointer {
  const ShownGizmo* gizmo = nullptr;
  const GizmoMark* mark = nullptr;
};
UnderPointer under(const std::vector<ShownGizmo>& gizmos, ImVec2 point) {
  for (const ShownGizmo& gizmo : gizmos)
    if (const GizmoMark* mark = mark_at(gizmo, point)) return {&gizmo, mark};
  return {};
}

Vec2d place_of(ImVec2 point, const Area& area) { return {point.x - area.min.x, point.y - area.min.y}; }

}  // namespace

void space_gizmo_input(Session& session, SpacePanelState& state, const PicturesState& pictures, const Area& area) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated()) {
    state.gizmo_drag.reset();
    state.cancelled = false;
    const auto gizmos = gizmos_in_space(session, state, pictures, area);
    if (const auto [gizmo, mark] = under(gizmos, io.MousePos); mark)
      state.gizmo_drag = GizmoDrag{gizmo->gizmo, mark->part,      sight_of(state),      place_of(io.MousePos, area),
                                   gizmo->reach, session.scene(), session.view().camera};
  }
  if (!state.gizmo_drag) return;
  state.dragged = true;  // the click does not select what lies below
  if (ImGui::IsItemActive() && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
    drag_gizmo(session, *state.gizmo_drag, place_of(io.MousePos, area));
  if (!ImGui::IsItemActive()) {
    state.gizmo_drag.reset();
    session.end_drag();
  }
}

void draw_space_gizmos(const Session& session, const SpacePanelState& state, const PicturesState& pictures,
                       const Area& area) {
  const auto gizmos = gizmos_in_space(session, state, pictures, area);
  const auto [hovered, mark] = under(gizmos, ImGui::IsItemHovered() ? ImGui::GetIO().MousePos : ImVec2{-1e6f, -1e6f});
  for (const ShownGizmo& gizmo : gizmos) {
    std::optional<GizmoPart> held;
    if (state.gizmo_drag) {
      if (state.gizmo_drag->gizmo.object == gizmo.gizmo.object) held = state.gizmo_drag->part;
    } else if (hovered == &gizmo) {
      held = mark->part;
    }
    draw_gizmo(*ImGui::GetWindowDrawList(), gizmo, held, area);
    record_gizmo(gizmo.gizmo.object ? "gizmo/object" : "gizmo/camera", gizmo, area);
  }
}

bool SpacePanel::cancel_drag() {
  if (!state_.gizmo_drag) return false;
  session_.cancel_drag(gizmo_step);
  state_.gizmo_drag.reset();
  state_.cancelled = true;
  return true;
}

}  // namespace ps::gui
