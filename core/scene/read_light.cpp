#include <fmt/format.h>

#include <algorithm>

#include "scene/scene_draft.h"

namespace ps {

Vec3d read_attenuation(const SceneValues& values, const SceneTerm& term) {
  const Vec3d attenuation = values.vec3(term);
  for (int axis = 0; axis < 3; ++axis)
    if (attenuation[axis] < 0) values.fail(term, "constant, linear and quadratic factors of at least 0");
  if (attenuation == Vec3d{0, 0, 0}) values.fail(term, "a factor above 0");
  return attenuation;
}

namespace {

LightKind read_light_kind(const SceneValues& values, const SceneTerm& term) {
  const std::string expected = "ambient, point or directional";
  const std::string key = values.name(term, expected);
  const auto found =
      std::find_if(light_kinds.begin(), light_kinds.end(), [&](LightKind kind) { return light_kind_key(kind) == key; });
  if (found == light_kinds.end()) values.fail(term, expected);
  return *found;
}

}  // namespace

void read_light(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry,
                           {"type", "intensity", "position", "direction", "color", "specular_color", "ambient_color",
                            "attenuation", "radius"});
  Light light;
  light.kind = read_light_kind(values, fields.require("type"));
  switch (light.kind) {
  case LightKind::ambient:
    fields.forbid({"position", "direction"}, "no position or direction: ambient light has none");
    fields.forbid({"specular_color", "ambient_color"}, "'color' alone: ambient light is only ambient");
    break;
  case LightKind::point:
    fields.forbid({"direction"}, "'position': a point light has no direction");
    light.position = values.vec3(fields.require("position"));
    break;
  case LightKind::directional:
    fields.forbid({"position"}, "'direction': a directional light has no position");
    light.direction = values.direction(fields.require("direction"));
    break;
  }
  if (const auto* term = fields.find("attenuation")) {
    if (light.kind != LightKind::point) values.fail(*term, "no attenuation: only point lights have a distance");
    light.attenuation = read_attenuation(values, *term);
  }
  if (const auto* term = fields.find("radius")) {
    if (light.kind != LightKind::point) values.fail(*term, "no radius: only point lights have a size");
    light.radius = values.in_range(*term, 0, max_scene_number);
  }
  light.intensity = values.in_range(fields.require("intensity"), 0, max_scene_number);
  if (const auto* term = fields.find("color")) light.colour = values.colour(*term);
  if (const auto* term = fields.find("specular_color")) light.specular_colour = values.colour(*term);
  if (const auto* term = fields.find("ambient_color")) light.ambient_colour = values.colour(*term);
  draft.lights.push_back(light);
  if (draft.lights.size() > max_scene_lights)
    values.fail_at(entry.line, entry.column, "'light'", fmt::format("at most {} lights", max_scene_lights));
}

}  // namespace ps
