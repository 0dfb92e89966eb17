#include <cmath>
#include <glm/geometric.hpp>

#include "gui/panels/pictures/handles_view.h"
#include "gui/panels/pictures/orbit_ball.h"
#include "gui/panels/pictures/picture_gizmo.h"
#include "gui/panels/pictures/pictures_panel.h"
#include "gui/platform/tracker.h"
#include "gui/session/camera_moves.h"

namespace ps::gui {
namespace {

constexpr double click_slack = 4;            // a drag begins beyond this
constexpr double wheel_factor = 1.25;        // zoom by one notch
constexpr double radians_per_pixel = 0.004;  // look and orbit
constexpr double fly_share = 0.6;            // of the scene's reach, in a second

void store(Session& session, const PictureTransform& transform, Vec2i size) {
  if (size.x <= 0 || size.y <= 0) return;
  session.navigate([&](Document& document) {
    document.view.zoom = transform.zoom;
    document.view.middle = {transform.centre.x / size.x, transform.centre.y / size.y};
  });
}

void zoom_by_wheel(Session& session, PicturesState& state, const Area& area) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel == 0) return;
  const auto zoomed = zoomed_about(state.drawn.transform, std::pow(wheel_factor, static_cast<double>(io.MouseWheel)),
                                   io.MousePos, area);
  state.drawn.transform = zoomed;
  store(session, zoomed, state.pictures[0].size());
}

PictureDrag drag_of_button(const ImGuiIO& io, std::optional<float> split_at) {
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) return PictureDrag::look;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Middle)) return PictureDrag::pan;
  if (io.KeyShift) return PictureDrag::region;
  if (io.KeyAlt) return PictureDrag::orbit;
  if (io.KeyCtrl) return PictureDrag::look;
  if (split_at && std::abs(io.MousePos.x - *split_at) <= px(divider_reach)) return PictureDrag::divider;
  return PictureDrag::undecided;
}

void turn_by_drag(Session& session, PictureDrag drag, ImVec2 by) {
  const Scene& scene = session.scene();
  const Camera camera = session.view().camera;
  const double right = by.x * radians_per_pixel, down = by.y * radians_per_pixel;
  const Vec3d& up = scene.camera.up;
  if (drag == PictureDrag::look) {
    const Camera next = turned(camera, right, -down, up);
    session.edit("look around", "look", [&](Document& document) { document.view.camera = next; });
  } else {
    // The scene follows the hand, so the camera goes the other way.
    const Camera next = orbited(camera, right, -down, up, scene_centre(scene));
    session.edit("orbit", "orbit", [&](Document& document) { document.view.camera = next; });
  }
}

/// Shift and the left button: the rectangle between where the drag began and where it is becomes all that is rendered.
void drag_region(Session& session, const PicturesState& state, const Area& area) {
  const ImVec2 to = ImGui::GetIO().MousePos;
  if (std::hypot(to.x - state.mouse.drag_from.x, to.y - state.mouse.drag_from.y) <= px(click_slack)) return;
  const Vec2i size = state.pictures[0].size();
  const Vec2i a = state.drawn.transform.pixel_at(state.mouse.drag_from, area),
              b = state.drawn.transform.pixel_at(to, area);
  const TileRect region{std::max(std::min(a.x, b.x), 0), std::max(std::min(a.y, b.y), 0),
                        std::min(std::max(a.x, b.x) + 1, size.x), std::min(std::max(a.y, b.y) + 1, size.y)};
  if (region.x0 < region.x1 && region.y0 < region.y1) session.set_region(region);
}

void drag(Session& session, PicturesState& state, Side side, const Area& area) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 by = io.MouseDelta;
  switch (state.mouse.drag) {
  case PictureDrag::none:
    return;
  case PictureDrag::handle: {
    const Vec2d from = state.drawn.transform.to_picture(state.mouse.drag_from, area);
    const Vec2d to = state.drawn.transform.to_picture(io.MousePos, area);
    const Vec2d moved{state.mouse.grabbed->place.x + to.x - from.x, state.mouse.grabbed->place.y + to.y - from.y};
    if (by.x != 0 || by.y != 0) drag_handle(session, side, *state.mouse.grabbed, moved);
    return;
  }
  case PictureDrag::gizmo:
    if (by.x != 0 || by.y != 0)
      drag_gizmo(session, *state.mouse.gizmo_drag, state.drawn.transform.to_picture(io.MousePos, area));
    return;
  case PictureDrag::undecided:
    if (std::hypot(io.MousePos.x - state.mouse.drag_from.x, io.MousePos.y - state.mouse.drag_from.y) <= px(click_slack))
      return;
    if (state.mouse.on_ball) {
      state.mouse.drag = PictureDrag::orbit;
      turn_by_drag(session, state.mouse.drag,
                   {io.MousePos.x - state.mouse.drag_from.x, io.MousePos.y - state.mouse.drag_from.y});
      return;
    }
    if (state.mouse.gizmo_drag || state.mouse.grabbed) {
      state.mouse.drag = state.mouse.gizmo_drag ? PictureDrag::gizmo : PictureDrag::handle;
      drag(session, state, side, area);
      return;
    }
    state.mouse.drag = PictureDrag::pan;
    store(session,
          panned(state.drawn.transform,
                 {io.MousePos.x - state.mouse.drag_from.x, io.MousePos.y - state.mouse.drag_from.y},
                 state.pictures[0].size()),
          state.pictures[0].size());
    return;
  case PictureDrag::pan:
    if (by.x != 0 || by.y != 0)
      store(session, panned(state.drawn.transform, by, state.pictures[0].size()), state.pictures[0].size());
    return;
  case PictureDrag::region:
    drag_region(session, state, area);
    return;
  case PictureDrag::look:
  case PictureDrag::orbit:
    if (by.x != 0 || by.y != 0) turn_by_drag(session, state.mouse.drag, by);
    return;
  case PictureDrag::divider: {
    const Area seen = state.drawn.transform.seen(state.pictures[0].size(), area);
    const double share = std::clamp((io.MousePos.x - seen.min.x) / std::max(seen.width(), 1.f), 0.f, 1.f);
    session.navigate([&](Document& document) { document.split = share; });
    return;
  }
  }
}

}  // namespace

void picture_input(Session& session, PicturesState& state, Side side, const Area& area, std::optional<float> split_at) {
  if (!session.has_scene() || state.pictures[0].levels.empty()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  const bool held = ImGui::IsItemActive();
  const Vec2i size = state.pictures[0].size();
  const Vec2i pixel = state.drawn.transform.pixel_at(io.MousePos, area);
  const bool on_picture = pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.x && pixel.y < size.y;
  const Side under = split_at && io.MousePos.x >= *split_at ? other_side(side) : side;

  if (hovered && on_picture && !state.drawn.covers.hidden[index_of(under)]) state.mouse.hover = Hover{under, pixel};
  if (hovered) zoom_by_wheel(session, state, area);
  if (ImGui::IsItemActivated()) {
    state.mouse.drag = drag_of_button(io, split_at);
    state.mouse.drag_from = io.MousePos;
    state.mouse.drag_side = under;
    state.mouse.grabbed.reset();
    state.mouse.gizmo_drag.reset();
    const auto ball = orbit_ball_area(session, state, area);
    state.mouse.on_ball = state.mouse.drag == PictureDrag::undecided && ball && ball->contains(io.MousePos);
    if (state.mouse.drag == PictureDrag::undecided && !state.mouse.on_ball)
      state.mouse.gizmo_drag = take_gizmo(session, state, under, area, io.MousePos);
    if (state.mouse.drag == PictureDrag::undecided && state.handles && !state.mouse.gizmo_drag &&
        !state.mouse.on_ball) {
      const auto handles =
          visible_handles(session.scene(), session.view(), session.settings(under), state.drawn.transform, area);
      if (const Handle* handle = handle_at(handles, io.MousePos, state.drawn.transform, area))
        state.mouse.grabbed = *handle;
    }
  }
  if (held) drag(session, state, state.mouse.drag_side, area);
  if (ImGui::IsItemDeactivated()) {
    if (state.mouse.drag == PictureDrag::undecided && on_picture) {
      session.set_pixel(pixel);
      session.navigate([&](Document& document) { document.picked = under; });
    }
    if (state.mouse.drag == PictureDrag::look || state.mouse.drag == PictureDrag::orbit ||
        state.mouse.drag == PictureDrag::handle || state.mouse.drag == PictureDrag::gizmo)
      session.end_drag();
    state.mouse.drag = PictureDrag::none;
  }
  const bool on_divider = split_at && std::abs(io.MousePos.x - *split_at) <= px(divider_reach);
  if (state.mouse.drag == PictureDrag::divider || (hovered && state.mouse.drag == PictureDrag::none && on_divider))
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
}

bool flying(const PicturesState& state) { return state.keys.fly || state.mouse.drag == PictureDrag::look; }

bool fly_camera(Session& session, const PicturesState& state, double seconds) {
  if (!session.has_scene() || !flying(state) || ImGui::GetIO().WantTextInput || ImGui::GetIO().KeyCtrl) return false;
  const auto axis = [](Key more, Key less) {
    return (place_is_held(more) ? 1.0 : 0.0) - (place_is_held(less) ? 1.0 : 0.0);
  };
  const double right = axis(Key::d, Key::a), up = axis(Key::e, Key::q), forward = axis(Key::w, Key::s);
  if (right == 0 && up == 0 && forward == 0) return false;
  const Camera camera = session.view().camera;
  const double step = fly_share * scene_reach(session.scene(), camera) * seconds;
  const Camera next = moved(camera, right * step, up * step, forward * step);
  session.edit("fly", "fly", [&](Document& document) { document.view.camera = next; });
  return true;
}

}  // namespace ps::gui
