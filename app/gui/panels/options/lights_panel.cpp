#include "gui/panels/options/lights_panel.h"

#include <fmt/format.h>

#include <cstddef>

#include "gui/panels/options/vector_field.h"
#include "gui/session/scene_contents.h"
#include "gui/widgets/widgets.h"
#include "record/value_text.h"
#include "render/story/names.h"
#include "scene/scene_text.h"

namespace ps::gui {
namespace {

/// Sets a property of light `index` after a field was edited.
void set_light(Session& session, std::size_t index, std::string_view property, std::string_view words,
               const std::string& value, const Edit& edit) {
  if (edit.changed)
    session.edit_property(fmt::format("{} of light {}", words, index),
                          {fmt::format("light.{}.{}", index, property), value});
  if (edit.finished) session.end_drag();
}

/// The colour that each term of the illumination equation takes of the light, and its size.
void term_fields(Session& session, std::size_t index, const Light& light) {
  struct Term {
    const char *property, *label, *tooltip;
    Vec3d colour;
  };
  for (Term term :
       {Term{"color", "Diffuse: red, green, blue", "Of light that surfaces scatter.", light.colour},
        Term{"specular_color", "Highlights", "Of the highlights that it makes.", highlight_colour(light)},
        Term{"ambient_color", "Ambient", "Of light that it adds everywhere, in shadow too.", light.ambient_colour}}) {
    show_text(term.label, {.quiet = true});
    const auto edit = vector_field(fmt::format("{}/{}", index, term.property), term.colour,
                                   {.minimum = 0, .maximum = 1}, term.tooltip);
    set_light(session, index, term.property, term.label, scene_colour(term.colour), edit);
  }
  if (light.kind != LightKind::point) return;
  show_text("Radius", {.quiet = true});
  double radius = light.radius;
  const auto edit = number(fmt::format("{}/radius", index), radius, {.minimum = 0, .maximum = 10},
                           {.tooltip = "World units. Above 0 it is an area light: see the option Shadow samples."});
  set_light(session, index, "radius", "radius", scene_number(radius), edit);
}

}  // namespace

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
  const auto lights = *session.scene().lights;  // a button may change the scene's own
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
    set_light(session, i, "intensity", "intensity", fmt::format("{}", intensity), edit);
    const std::string place = fmt::format("{}/place", i);
    if (light.kind == LightKind::point) value_text(place, "at " + vector_text(light.position), {.quiet = true});
    if (light.kind == LightKind::directional)
      value_text(place, "towards " + vector_text(light.direction), {.quiet = true});
    if (movable && static_cast<int>(i) == chosen) term_fields(session, i, light);
    if (button(fmt::format("{}/duplicate", i), "Duplicate", Emphasis::quiet)) duplicate_light(session, selected, i);
    ImGui::SameLine(0, px(2));
    if (button(fmt::format("{}/delete", i), "Delete", Emphasis::quiet)) remove_light(session, i);
    ImGui::PopID();
  }
  for (const auto& [kind, label] : {std::pair{"point", "Add point light"}, {"directional", "Add directional light"}})
    if (button(fmt::format("add-{}", kind), label)) add_light(session, selected, kind);
}

}  // namespace ps::gui
