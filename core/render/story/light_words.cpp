#include "render/story/light_words.h"

#include <fmt/format.h>

#include <cmath>

#include "record/value_text.h"
#include "render/story/names.h"

namespace ps {
namespace {

constexpr double least_light = 1e-13;

std::string highlight_text(const LightEvent& light) {
  if (light.specular == 0) return {};
  return adds_nothing(light.specular) ? ", specular adds nothing"
                                      : fmt::format(", specular {}", number_text(light.specular));
}

}  // namespace

bool adds_nothing(double intensity) { return std::abs(intensity) < least_light; }

std::string light_text(const Vec3d& light) {
  return light.x == light.y && light.y == light.z ? number_text(light.x) : vector_text(light);
}

std::string light_effect_text(const Scene& scene, const LightEvent& light, LightWords words) {
  if (light.ambient != 0) {
    LightEvent other = light;
    other.ambient = 0;
    // It does add something, so the brief reason is the true one.
    const LightWords of_others = light.below_horizon ? LightWords::brief : words;
    return fmt::format("{}, ambient {}", light_effect_text(scene, other, of_others), number_text(light.ambient));
  }
  const bool whole = words == LightWords::whole;
  if (light.kind == LightKind::ambient)
    return adds_nothing(light.diffuse) ? "emits no light" : fmt::format("{} everywhere", number_text(light.diffuse));
  if (light.below_horizon) {
    // The book's highlight does not ask which way the surface faces.
    if (!adds_nothing(light.specular)) return "surface faces away, no diffuse" + highlight_text(light);
    return whole ? "adds nothing: the surface faces away from it" : "surface faces away";
  }
  if (light.blocker) return "blocked by " + primitive_name(scene, *light.blocker);
  if (light.visible <= 0) return "in shadow";
  // A surface that faces an unblocked light is lit, unless the light or its diffuse term is switched off.
  if (light.diffuse == 0 && light.specular == 0) return "adds no light";
  const std::string share = whole && light.visible < 1
                                ? fmt::format("{} % reaches the point, ", number_text(100 * light.visible))
                                : std::string();
  const std::string diffuse =
      adds_nothing(light.diffuse) ? "diffuse adds nothing" : fmt::format("diffuse {}", number_text(light.diffuse));
  return share + diffuse + highlight_text(light);
}

}  // namespace ps
