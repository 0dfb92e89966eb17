#include "frame/left_out.h"

#include <fmt/format.h>

namespace ps {

std::string brief_text(const LeftOutBrief& brief) {
  return brief.verb == BriefVerb::leaves_out ? "leaves out " + brief.words : brief.words;
}

std::vector<std::string> brief_texts(const std::vector<LeftOutBrief>& briefs) {
  std::vector<std::string> texts;
  texts.reserve(briefs.size());
  for (const LeftOutBrief& brief : briefs) texts.push_back(brief_text(brief));
  return texts;
}

std::optional<LeftOut> missing_light(const SceneTraits& traits, const Settings& settings, std::string_view subject) {
  if (!settings.lighting || !(traits.spheres || traits.triangles || traits.solids || traits.csg)) return {};
  const auto black = [&](std::string_view reason, std::string_view notice, Remedy other) {
    LeftOut found{LeftOutKind::effect,
                  {BriefVerb::own, fmt::format("shows black surfaces: {}", reason)},
                  fmt::format("{} shows black surfaces, since {}. Set lighting = off to see their local colours.",
                              subject, reason),
                  std::string(notice),
                  {{"Lighting off", "lighting=off"}}};
    if (!other.setting.empty()) found.remedies.insert(found.remedies.begin(), std::move(other));
    return found;
  };
  if (traits.light_count == 0) return black("the scene has no light", "No light: surfaces are black.", {});
  if (traits.shining_lights == 0)
    return black("no light of the scene shines", "No light shines: surfaces are black.", {});
  const bool one = settings.light_shown != all_lights;
  if (one && !shines(traits, static_cast<std::size_t>(settings.light_shown)))
    return black("the only light shown adds nothing", "No light: the only one shown adds nothing.",
                 {"All lights", "light-shown=all"});
  return {};
}

bool asks_for_shadows(const SceneTraits& traits, const Settings& settings) {
  return settings.lighting && fills(settings.draw) && traits.casting_lights && settings.shadows != Shadows::none;
}

bool asks_for_reflections(const SceneTraits& traits, const Settings& settings) {
  const bool mirrors = traits.mirrors || (traits.reflection_maps && !settings.textures);
  return mirrors && fills(settings.draw) && settings.reflection_depth > 0;
}

}  // namespace ps
