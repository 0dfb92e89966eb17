#include <fmt/format.h>

#include "gui/frame/app.h"
#include "gui/session/camera_moves.h"

namespace ps::gui {
namespace {

/// A vector as a scene file has it, to the last bit.
std::string scene_text(const Vec3d& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

}  // namespace

/// Moves the selected light by shares of the scene's reach along the camera's axes. Repeated presses are one step.
void App::move_light(double right, double up, double forward) {
  const auto& lights = *session_.scene().lights;
  const auto index = static_cast<std::size_t>(selected_light(session_.scene(), options_panel_.selected_light));
  if (index >= lights.size()) return;
  const Camera camera = session_.view().camera;
  const double reach = scene_reach(session_.scene(), camera);
  const Light light = moved_light(lights[index], camera, right * reach, up * reach, forward * reach, reach);
  const bool is_point = light.kind == LightKind::point;
  const SceneEdit change{fmt::format("light.{}.{}", index, is_point ? "position" : "direction"),
                         scene_text(is_point ? light.position : light.direction)};
  session_.edit(fmt::format("move light {}", index), change.path,
                [&](Document& document) { edit_scene(document, change); });
}

}  // namespace ps::gui
