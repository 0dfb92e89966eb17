#include "hardware/left_out.h"

#include <fmt/format.h>

namespace ps::hardware {
namespace {

LeftOut missing(LeftOutKind kind, std::string_view what, std::string_view reason, const Remedy& remedy) {
  return {kind,
          fmt::format("leaves out {}", what),
          fmt::format("The hardware renderer leaves out {}: {}. Set {} to see them.", what, reason, remedy.setting),
          fmt::format("No {}: {}.", what, reason),
          {remedy}};
}

}  // namespace

std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings) {
  const Remedy rays{"Ray tracer", "renderer=ray-tracer"};
  std::vector<LeftOut> all;
  if (traits.csg) all.push_back(missing(LeftOutKind::objects, "CSG objects", "their surfaces need rays", rays));
  if (traits.transparent)
    all.push_back(missing(LeftOutKind::effect, "transparent surfaces", "light through a surface needs rays", rays));
  if (asks_for_shadows(traits, settings) && settings.shadows == Shadows::traced)
    all.push_back(missing(LeftOutKind::effect, "shadows", "traced shadows need rays", rays));
  if (asks_for_reflections(traits, settings) && settings.environment == Environment::none)
    all.push_back(missing(LeftOutKind::effect, "reflections", "reflected rays need a ray tracer", rays));
  return all;
}

}  // namespace ps::hardware
