#include "gui/panels/options/light_actions.h"

#include <fmt/format.h>

#include "gui/panels/options/lights_panel.h"
#include "gui/session/camera_moves.h"
#include "gui/session/scene_contents.h"
#include "scene/scene_text.h"

namespace ps::gui {
namespace {

constexpr double light_share = 0.05;  // of the scene's reach, for one press

/// Moves the selected light by shares of the scene's reach along the camera's axes. Repeated presses are one step.
void move_light(Session& session, int wanted, double right, double up, double forward) {
  const auto& lights = *session.scene().lights;
  const auto index = static_cast<std::size_t>(selected_light(session.scene(), wanted));
  if (index >= lights.size()) return;
  const Camera camera = session.view().camera;
  const double reach = scene_reach(session.scene(), camera);
  const Light light = moved_light(lights[index], camera, right * reach, up * reach, forward * reach, reach);
  const bool is_point = light.kind == LightKind::point;
  session.edit_property(fmt::format("move light {}", index),
                        {fmt::format("light.{}.{}", index, is_point ? "position" : "direction"),
                         scene_vec(is_point ? light.position : light.direction)});
}

}  // namespace

void add_light_actions(Actions& actions, Session& session, int& selected) {
  const auto any = [&session, &selected] {
    return selected_light(session.scene(), selected) < static_cast<int>(session.scene().lights->size());
  };
  struct Push {
    const char *name, *label, *keys;
    double right, up, forward;
  };
  for (const Push& by :
       {Push{"light-away", "Light away from the camera", "I", 0, 0, 1},
        Push{"light-near", "Light nearer", "K", 0, 0, -1}, Push{"light-left", "Light left", "J", -1, 0, 0},
        Push{"light-right", "Light right", "L", 1, 0, 0}, Push{"light-down", "Light down", "U", 0, -1, 0},
        Push{"light-up", "Light up", "O", 0, 1, 0}})
    actions.add({.name = by.name,
                 .label = by.label,
                 .group = "Light",
                 .keys = by.keys,
                 .by_place = true,
                 .kind = ActionKind::repeat,
                 .run =
                     [&session, &selected, by] {
                       move_light(session, selected, by.right * light_share, by.up * light_share,
                                  by.forward * light_share);
                     },
                 .enabled = any});
  const auto chosen = [&session, &selected] {
    return static_cast<std::size_t>(selected_light(session.scene(), selected));
  };
  ActionGroup lights(actions, "Light", any), scene(actions, "Light", [&session] { return session.has_scene(); });
  scene.add("light-add-point", "Add a point light", "",
            [&session, &selected] { add_light(session, selected, "point"); });
  scene.add("light-add-directional", "Add a directional light", "",
            [&session, &selected] { add_light(session, selected, "directional"); });
  lights.add("light-duplicate", "Duplicate the light", "",
             [&session, &selected, chosen] { duplicate_light(session, selected, chosen()); });
  lights.add("light-delete", "Delete the light", "", [&session, chosen] { remove_light(session, chosen()); });
}

}  // namespace ps::gui
