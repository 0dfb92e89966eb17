#include <fmt/format.h>

#include "scene/scene_draft.h"

namespace ps {

void read_light(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry, {"type", "intensity", "position", "direction", "color"});
  Light light;
  const SceneTerm& type = fields.require("type");
  const std::string kind = values.name(type, "ambient, point or directional");
  if (kind == "ambient") {
    light.kind = LightKind::ambient;
    fields.forbid({"position", "direction"}, "no place or direction: ambient light has none");
  } else if (kind == "point") {
    light.kind = LightKind::point;
    fields.forbid({"direction"}, "'position': a point light has no direction");
    light.position = values.vec3(fields.require("position"));
  } else if (kind == "directional") {
    light.kind = LightKind::directional;
    fields.forbid({"position"}, "'direction': a directional light has no position");
    light.direction = values.direction(fields.require("direction"));
  } else {
    values.fail(type, "ambient, point or directional");
  }
  light.intensity = values.in_range(fields.require("intensity"), 0, max_scene_number);
  if (const auto* term = fields.find("color")) light.colour = values.colour(*term);
  draft.lights.push_back(light);
  if (draft.lights.size() > max_scene_lights)
    values.fail_at(entry.line, entry.column, "'light'", fmt::format("at most {} lights", max_scene_lights));
}

}  // namespace ps
