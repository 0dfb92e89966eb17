#include "raster/setup/left_out.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace ps {

std::vector<LeftOut> left_out_by_fragments(const SceneTraits& traits, const Settings& settings,
                                           std::string_view subject) {
  const Remedy rays{"Ray tracer", "renderer=ray-tracer"};
  std::vector<LeftOut> all;
  if (traits.csg)
    all.push_back({LeftOutKind::objects,
                   {BriefVerb::leaves_out, "CSG"},
                   fmt::format("{} leaves out CSG objects, whose surfaces are computed per ray and not as triangles. "
                               "Set renderer = ray-tracer to see them.",
                               subject),
                   "No CSG: its surfaces need rays.",
                   {rays}});
  const bool may_blend = settings.renderer == Renderer::rasterizer;
  if (traits.transparent && !(may_blend && settings.blending != Blending::off)) {
    std::vector<Remedy> remedies{rays};
    if (may_blend) remedies.push_back({"Blending", "blending=sorted"});
    all.push_back(
        {LeftOutKind::effect,
         {BriefVerb::own, "shows transparent surfaces as opaque"},
         fmt::format("{} shows transparent surfaces as opaque, or cuts them out where an opacity map is below "
                     "1/2. Set renderer = ray-tracer, or blending = sorted with the rasterizer, to see through them.",
                     subject),
         "No transparency: it needs rays, or blending.",
         std::move(remedies)});
  }
  if (traits.light_maps && settings.textures && settings.lighting && settings.shading != Shading::phong)
    all.push_back({LeftOutKind::effect,
                   {BriefVerb::leaves_out, "specular maps"},
                   fmt::format("{} leaves out maps of highlights and ambient light with flat or Gouraud shading. Set "
                               "shading = phong to see them.",
                               subject),
                   "No specular maps: they need the light at each pixel.",
                   {{"Phong shading", "shading=phong"}}});
  if (asks_for_shadows(traits, settings) && settings.shadows == Shadows::traced)
    all.push_back(
        {LeftOutKind::effect,
         {BriefVerb::leaves_out, "shadows"},
         fmt::format("{} has no shadow rays, so shadows = traced leaves out the shadows. Set shadows = map or "
                     "stencil-depth-fail to see them.",
                     subject),
         "No shadows: traced shadows need rays.",
         {{"Shadow map", "shadows=map"}, {"Stencil", "shadows=stencil-depth-fail"}}});
  if (asks_for_reflections(traits, settings) && settings.environment == Environment::none)
    all.push_back(
        {LeftOutKind::effect,
         {BriefVerb::leaves_out, "reflections"},
         fmt::format("{} traces no reflected rays, so it leaves out reflections. Set environment = cube-map to "
                     "see them.",
                     subject),
         "No reflections: reflected rays need a ray tracer.",
         {{"Cube map", "environment=cube-map"}, rays}});
  if (asks_for_reflections(traits, settings) && traits.dynamic && settings.environment != Environment::none &&
      settings.environment_objects == EnvironmentObjects::fixed)
    all.push_back({LeftOutKind::effect,
                   {BriefVerb::own, "leaves dynamic objects out of mirrors"},
                   fmt::format("{} leaves dynamic objects out of the environment maps, so no mirror shows them. Set "
                               "environment-objects = all to see them there.",
                               subject),
                   "No dynamic objects in mirrors.",
                   {{"All objects", "environment-objects=all"}}});
  if (fills(settings.draw))
    if (auto dark = missing_light(traits, settings, subject)) all.push_back(std::move(*dark));
  return all;
}

std::optional<LeftOut> rounded_by_fragments(const SceneTraits& traits, const Settings& settings,
                                            std::string_view subject, const Remedy& remedy) {
  const bool places_count = traits.point_lights || traits.specular || traits.textures || traits.reflective;
  if (!settings.camera_relative || !traits.rounds_places || !places_count) return {};
  return LeftOut{LeftOutKind::effect,
                 {BriefVerb::own, "rounds places in float"},
                 fmt::format("{} rounds the points of surfaces: they lie too far from the scene's middle, or between "
                             "vertices that do. The scene needs precision = double.",
                             subject),
                 "Points are rounded: needs precision = double.",
                 {remedy}};
}

}  // namespace ps
