#include <string_view>

#include <fmt/format.h>

#include "options/listing.h"
#include "textbook/listing_field.h"
#include "textbook/renderer.h"
#include "textbook/slow_motion.h"

namespace ps {
namespace {

const Listing& chosen_listing(const SceneTraits& traits, const Settings& settings) {
  return *listing_of(settings, traits).listing;
}

bool listing_shows_objects(const SceneTraits& traits, const Settings& settings) {
  const ListingDraws& draws = chosen_listing(traits, settings).draws;
  return (traits.spheres && draws.spheres) || (traits.triangles && draws.models) ||
         (traits.canvas_items && draws.canvas_lines) || (traits.canvas_triangles && draws.canvas_triangles);
}

/// The name of each kind of object, whether the scene has it and the listing shows it, and what to set to see it.
struct ListingGap {
  LeftOutKind kind;
  bool missing;
  std::string_view what, remedy;  ///< the remedy as key and value, with spaces
};

std::vector<LeftOut> gaps_of_listing(const SceneTraits& traits, const Settings& settings) {
  const Listing& listing = chosen_listing(traits, settings);
  const ListingDraws& draws = listing.draws;
  const bool shows_space = draws.spheres || draws.models;
  const bool lit = shows_space && settings.lighting && draws.light;
  constexpr auto objects = LeftOutKind::objects;
  constexpr auto effect = LeftOutKind::effect;
  constexpr std::string_view in_space = "renderer = ray-tracer", on_canvas = "renderer = rasterizer";
  const ListingGap gaps[] = {
      {objects, traits.spheres && !draws.spheres, "spheres", in_space},
      {objects, traits.triangles && !draws.models, "models made of triangles", in_space},
      {objects, traits.solids, "planes, rectangles, boxes and cylinders", in_space},
      {objects, traits.csg, "CSG", in_space},
      {objects, traits.canvas_items && !draws.canvas_lines && !draws.canvas_triangles, "what is drawn on the canvas",
       on_canvas},
      {objects, traits.canvas_items && !traits.canvas_triangles && !draws.canvas_lines && draws.canvas_triangles,
       "lines on the canvas", on_canvas},
      {objects, traits.canvas_triangles && draws.canvas_lines && !draws.canvas_triangles, "triangles on the canvas",
       on_canvas},
      {effect, traits.canvas_intensities && draws.canvas_triangles && !draws.canvas_intensities,
       "intensities at the vertices of triangles on the canvas", on_canvas},
      {effect, traits.canvas_gradients && draws.canvas_triangles && !draws.canvas_gradients,
       "gradients between vertices of different colours", on_canvas},
      {effect, shows_space && settings.lighting && fills(settings.draw) && !draws.light, "light", in_space},
      {effect, lit && traits.coloured_lights && !draws.light_colours, "colours of lights", in_space},
      {effect, lit && traits.attenuated && settings.attenuation, "attenuation of lights", in_space},
      {effect, lit && ((traits.tinted && !draws.tints) || traits.light_maps), "colours of highlights and ambient light",
       in_space},
      {effect, lit && traits.normal_maps && settings.normal_mapping && !draws.normal_maps, "normal maps", in_space},
      {effect, shows_space && traits.height_maps && settings.parallax != Parallax::off, "reliefs", in_space},
      {effect, shows_space && draws.light && asks_for_shadows(traits, settings) && !draws.shadows, "shadows", in_space},
      {effect,
       listing.order == ListingOrder::object_by_object && draws.shadows && asks_for_shadows(traits, settings) &&
           traits.point_lights,
       "shadows of point lights", in_space},
      {effect, shows_space && asks_for_reflections(traits, settings) && !draws.reflections, "reflections", in_space},
      {effect, shows_space && traits.reflection_maps && settings.textures && settings.reflection_depth > 0,
       "reflection maps", in_space},
      {effect, shows_space && traits.textures && !draws.textures, "textures", in_space},
      {effect, shows_space && traits.transparent, "transparency", in_space}};
  std::vector<LeftOut> all;
  for (const ListingGap& gap : gaps) {
    if (!gap.missing) continue;
    const bool rays = gap.remedy == in_space;
    all.push_back({gap.kind,
                   {BriefVerb::leaves_out, std::string(gap.what)},
                   fmt::format("The listing of {} leaves out {}; {} shows that.", listing.source, gap.what, gap.remedy),
                   fmt::format("Leaves out {}: not in the listing of {}.", gap.what, listing.source),
                   {{rays ? "Ray tracer" : "Rasterizer", rays ? "renderer=ray-tracer" : "renderer=rasterizer"}}});
  }
  const bool shows_a_surface = (traits.spheres && draws.spheres) || (traits.triangles && draws.models);
  Settings own = settings;
  if (!listing_reads(listing_of(settings, traits), "light-shown")) own.light_shown = all_lights;
  const bool white_for_black = traits.coloured_lights && !draws.light_colours;
  if (draws.light && shows_a_surface && !(traits.shining_lights == 0 && white_for_black))
    if (auto dark = missing_light(traits, own, fmt::format("The listing of {}", listing.source)))
      all.push_back(std::move(*dark));
  return all;
}

FastPath textbook_path(const Settings&, const SceneTraits&, Channel) {
  return {Machinery::clear, SurfaceShading::single, "a listing runs line by line"};
}

}  // namespace

RendererRow textbook_row() {
  return {.renderer = Renderer::textbook,
          .render = render_textbook,
          .inspect = inspect_textbook,
          .find_field = find_field_of_listing,
          .finds_lines = true,
          .counts = {Counter::nan_pixels},
          .fast_path = textbook_path,
          .left_out = gaps_of_listing,
          .shows_objects = listing_shows_objects,
          .subject =
              [](const SceneTraits& traits, const Settings& settings) {
                return fmt::format("the listing of {}", chosen_listing(traits, settings).source);
              },
          .slow_motion_lacks = listing_slow_motion_lacks,
          .slow_motion = run_listing_slowly};
}

}  // namespace ps
