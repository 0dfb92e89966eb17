#include "gui/panels/options/lights_panel.h"

#include <fmt/format.h>

#include <cstddef>

#include "gui/widgets/widgets.h"
#include "record/value_text.h"
#include "render/story/names.h"

namespace ps::gui {

int selected_light(const Scene& scene, int wanted) {
  const auto& lights = *scene.lights;
  const auto movable = [&](std::size_t index) { return lights[index].kind != LightKind::ambient; };
  if (wanted >= 0 && static_cast<std::size_t>(wanted) < lights.size() && movable(static_cast<std::size_t>(wanted)))
    return wanted;
  std::size_t index = 0;
  while (index < lights.size() && !movable(index)) ++index;
  return static_cast<int>(index);
}

void lights_panel(Session& session, int& selected, bool& open) {
  const auto& lights = *session.scene().lights;
  if (lights.empty()) return;
  if (!section("lights", "Lights of the scene", open, fmt::format("{}", lights.size()))) return;
  const NameScope scope("light");
  const int chosen = selected_light(session.scene(), selected);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light light = lights[i];
    const bool movable = light.kind != LightKind::ambient;
    ImGui::PushID(static_cast<int>(i));
    if (button_on_off(fmt::format("{}/select", i), light_name(session.scene(), static_cast<int>(i)),
                      movable && static_cast<int>(i) == chosen,
                      {.tooltip = "The keys I J K L U O move the chosen light.",
                       .disabled = movable ? "" : "Ambient light comes from everywhere."}))
      selected = static_cast<int>(i);
    double intensity = light.intensity;
    const auto edit = number(fmt::format("{}/intensity", i), intensity, {.minimum = 0, .maximum = 2},
                             {.tooltip = "Intensity", .width = 0});
    if (edit.changed)
      session.edit(fmt::format("intensity of light {}", i), fmt::format("light/{}", i), [&](Document& document) {
        edit_scene(document, {fmt::format("light.{}.intensity", i), fmt::format("{}", intensity)});
      });
    if (edit.finished) session.end_drag();
    const std::string place = fmt::format("{}/place", i);
    if (light.kind == LightKind::point) value_text(place, "at " + vector_text(light.position), {.quiet = true});
    if (light.kind == LightKind::directional)
      value_text(place, "towards " + vector_text(light.direction), {.quiet = true});
    ImGui::PopID();
  }
}

}  // namespace ps::gui
