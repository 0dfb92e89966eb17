#include "gui/panels/pictures/orbit_ball.h"

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>

#include "gui/base/record.h"
#include "gui/panels/pictures/marks.h"

namespace ps::gui {
namespace {

// Window pixels at scale 1.
constexpr double ball_radius = 22, ball_margin = 6, least_picture = 180;
constexpr std::array axis_names{"x", "y", "z"};

}  // namespace

std::optional<Area> orbit_ball_area(const Session& session, const PicturesState& state, const Area& area) {
  if (!session.has_scene() || !state.handles || flying(state)) return {};
  if (session.document().mode != ScreenMode::explore) return {};
  const Area seen = state.drawn.transform.seen(state.pictures[0].size(), area);
  if (std::min(seen.width(), seen.height()) < px(least_picture)) return {};
  const float size = px(2 * ball_radius), right = seen.max.x - px(ball_margin), top = seen.min.y + px(ball_margin);
  return Area{{right - size, top}, {right, top + size}};
}

void draw_orbit_ball(const Session& session, const PicturesState& state, const Area& area, const std::string& name,
                     bool hovered) {
  const auto ball = orbit_ball_area(session, state, area);
  if (!ball) return;
  const bool dragged =
      state.mouse.drag == PictureDrag::orbit && state.mouse.on_ball && ball->contains(state.mouse.drag_from);
  const bool idle = state.mouse.drag == PictureDrag::none || state.mouse.drag == PictureDrag::undecided;
  const bool held = dragged || (hovered && idle && ball->contains(ImGui::GetIO().MousePos));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle = ball->middle();
  const float radius = ball->width() / 2;
  list.AddCircleFilled(middle, radius, IM_COL32(0, 0, 0, held ? 190 : 110));
  list.AddCircle(middle, radius, IM_COL32(255, 255, 255, held ? 255 : 170), 0, px(held ? 2.5 : 1.5));
  const Camera camera = session.view().camera;
  const Mat3d to_camera = glm::inverse(Mat3d(camera.right, camera.up, camera.forward));
  ImFont* font = theme().font(Face::small);
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    const Vec3d axis = glm::normalize(to_camera[static_cast<int>(i)]);
    const float reach = radius - px(8);
    const ImVec2 tip{middle.x + static_cast<float>(axis.x) * reach, middle.y - static_cast<float>(axis.y) * reach};
    // An axis that points away from the eye is paler.
    const ImU32 colour = IM_COL32(255, 255, 255, axis.z > 0 ? 120 : 255);
    list.AddLine(middle, tip, colour, px(1.5));
    const ImVec2 extent = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, axis_names.at(i));
    list.AddText(font, font->FontSize, {tip.x - extent.x / 2, tip.y - extent.y / 2}, colour, axis_names.at(i));
  }
  controls().record(name, ball->min, ball->max, "orbit");
  if (!held) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  name_plate(list, "drag: around the scene", {ball->min.x, middle.y}, 8, area);
}

}  // namespace ps::gui
