#include "render/left_out.h"

#include <string_view>

#include <fmt/format.h>

#include "textbook/listing.h"

namespace ps {
namespace {

bool asks_for_shadows(const SceneTraits& traits, const Settings& settings) {
  return settings.lighting && settings.draw == Draw::filled && traits.casting_lights &&
         settings.shadows != Shadows::none;
}

bool asks_for_reflections(const SceneTraits& traits, const Settings& settings) {
  return traits.reflective && settings.draw == Draw::filled && settings.reflection_depth > 0;
}

bool has_objects_in_space(const SceneTraits& traits) {
  return traits.spheres || traits.triangles || traits.solids || traits.csg;
}

std::vector<LeftOut> left_out_by_rays(const SceneTraits& traits) {
  if (!traits.canvas_items) return {};
  return {
      {LeftOutKind::objects, "leaves out what is drawn on the canvas",
       "The ray tracer leaves out lines and triangles on the canvas: no ray meets them. Set renderer = rasterizer to "
       "see them."}};
}

std::vector<LeftOut> left_out_by_fragments(const SceneTraits& traits, const Settings& settings) {
  std::vector<LeftOut> all;
  if (traits.csg)
    all.push_back({LeftOutKind::objects, "leaves out CSG",
                   "The rasterizer leaves out objects made by CSG: their surface is only known ray by ray, not as "
                   "triangles. Set renderer = ray-tracer to see them."});
  if (traits.transparent)
    all.push_back(
        {LeftOutKind::effect, "shows glass opaque",
         "The rasterizer shows transparent surfaces opaque, or cuts them out where an opacity map is below 1/2: it "
         "follows no light through them. Set renderer = ray-tracer to see through them."});
  if (traits.light_maps && settings.textures && settings.lighting && settings.shading != Shading::phong)
    all.push_back(
        {LeftOutKind::effect, "leaves out maps of highlights",
         "The rasterizer reads maps of highlights and ambient light where it computes the light, so per vertex "
         "or triangle it leaves them out. Set shading = phong to see them."});
  if (asks_for_shadows(traits, settings) && settings.shadows == Shadows::traced)
    all.push_back(
        {LeftOutKind::effect, "leaves out shadows",
         "The rasterizer has no shadow rays, so shadows = traced leaves the shadows out. Set shadows = map or "
         "stencil-depth-fail to see them."});
  if (asks_for_reflections(traits, settings) && settings.environment == Environment::none)
    all.push_back({LeftOutKind::effect, "leaves out reflections",
                   "The rasterizer follows no reflected rays, so it leaves reflections out. Set environment = cube-map "
                   "to see them."});
  return all;
}

/// What each kind of thing is called, whether the scene has it and the listing shows it, and what to set to see it.
struct ListingGap {
  LeftOutKind kind;
  bool missing;
  std::string_view what, remedy;
};

std::vector<LeftOut> gaps_of_listing(const SceneTraits& traits, const Settings& settings) {
  const Listing& listing = *listing_of(settings, traits).listing;
  const ListingDraws& draws = listing.draws;
  const bool shows_space = draws.spheres || draws.models;
  constexpr auto objects = LeftOutKind::objects;
  constexpr auto effect = LeftOutKind::effect;
  constexpr std::string_view in_space = "renderer = ray-tracer", on_canvas = "renderer = rasterizer";
  const ListingGap gaps[] = {
      {objects, traits.spheres && !draws.spheres, "spheres", in_space},
      {objects, traits.triangles && !draws.models, "models made of triangles", in_space},
      {objects, traits.solids, "planes, rectangles, boxes and cylinders", in_space},
      {objects, traits.csg, "CSG", in_space},
      {objects, traits.canvas_items && !draws.canvas_lines, "what is drawn on the canvas", on_canvas},
      {objects, traits.canvas_triangles && draws.canvas_lines && !draws.canvas_triangles, "triangles on the canvas",
       on_canvas},
      {effect, shows_space && settings.lighting && settings.draw == Draw::filled && !draws.light, "light", in_space},
      {effect, shows_space && draws.light && asks_for_shadows(traits, settings) && !draws.shadows, "shadows", in_space},
      {effect, shows_space && asks_for_reflections(traits, settings) && !draws.reflections, "reflections", in_space},
      {effect, shows_space && traits.textures && !draws.textures, "textures", in_space},
      {effect, shows_space && traits.transparent, "transparency", in_space}};
  std::vector<LeftOut> all;
  for (const ListingGap& gap : gaps) {
    if (!gap.missing) continue;
    all.push_back(
        {gap.kind, fmt::format("leaves out {}", gap.what),
         fmt::format("The listing of {} leaves out {}; {} shows that.", listing.source, gap.what, gap.remedy)});
  }
  return all;
}

std::string subject(const SceneTraits& traits, const Settings& settings) {
  switch (settings.renderer) {
  case Renderer::ray_tracer:
    return "the ray tracer";
  case Renderer::rasterizer:
    return "the rasterizer";
  case Renderer::textbook:
    return fmt::format("the listing of {}", listing_of(settings, traits).listing->source);
  }
  return {};
}

}  // namespace

std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings) {
  switch (settings.renderer) {
  case Renderer::ray_tracer:
    return left_out_by_rays(traits);
  case Renderer::rasterizer:
    return left_out_by_fragments(traits, settings);
  case Renderer::textbook:
    return gaps_of_listing(traits, settings);
  }
  return {};
}

bool leaves_out_all(const SceneTraits& traits, const Settings& settings) {
  const bool in_space = has_objects_in_space(traits);
  if (!in_space && !traits.canvas_items) return false;
  switch (settings.renderer) {
  case Renderer::ray_tracer:
    return !in_space;
  case Renderer::rasterizer:
    return !traits.spheres && !traits.triangles && !traits.solids && !traits.canvas_items;
  case Renderer::textbook: {
    const ListingDraws& draws = listing_of(settings, traits).listing->draws;
    return !(traits.spheres && draws.spheres) && !(traits.triangles && draws.models) &&
           !(traits.canvas_items && draws.canvas_lines);
  }
  }
  return false;
}

std::string left_out_words(const SceneTraits& traits, const Settings& settings) {
  std::string words;
  for (const LeftOut& one : left_out(traits, settings))
    words += fmt::format("; {} {}", subject(traits, settings), one.brief);
  return words;
}

}  // namespace ps
