#include "textbook/listing_events.h"

#include "options/option.h"
#include "options/renderer_kind.h"
#include "textbook/report_parts.h"

namespace ps {

std::vector<Event> listing_events(const BookScene& book, const ListingTrace& trace) {
  const textbook::WatchReader reader(trace);
  PixelRecorder recorder(trace.pixel);
  if (sends_rays(stepped_like(trace.listing)))
    textbook::report_rays(book, reader, recorder);
  else if (trace.listing.listing->draws.canvas_lines || trace.listing.listing->draws.canvas_triangles)
    textbook::report_canvas_items(book, reader, recorder);
  else
    textbook::report_triangles(book, reader, recorder);
  return recorder.take();
}

Renderer stepped_like(const NamedListing& listing) {
  return renderer_for(listing.listing->order == ListingOrder::pixel_by_pixel ? PictureWay::rays
                                                                             : PictureWay::fragments);
}

Settings settings_as_listed(const NamedListing& listing, const Scene& scene, const Settings& settings) {
  const ListingDraws& draws = listing.listing->draws;
  const bool rays = sends_rays(stepped_like(listing));
  Settings as = settings;
  as.renderer = stepped_like(listing);
  as.precision = Precision::float64;
  as.sample_position = SamplePosition::corner;
  as.samples_per_pixel = as.multisampling = as.subsampling = as.anisotropy = 1;
  as.adaptive_sampling = false;
  as.projection = Projection::perspective;
  as.viewport_fit = ViewportFit::height;
  as.field_of_view_span = FieldOfViewSpan::edges;
  as.sphere_test = SphereTest::quadratic;
  as.self_hit = SelfHit::epsilon;
  as.epsilon_unit = EpsilonUnit::ray_parameter;
  as.illumination = Illumination::book;
  as.highlight = Highlight::phong;
  as.light_shown = all_lights;
  as.refraction = false;
  for (const Material& material : *scene.materials)
    if (material.normal_map >= 0) as.normal_mapping = draws.normal_maps;
  as.parallax = Parallax::off;
  as.environment = Environment::none;
  as.subpixel_bits = 0;
  as.fill_rule = FillRule::inclusive;
  as.line_algorithm = LineAlgorithm::interpolate;
  as.clipping = Clipping::none;
  as.blending = Blending::off;
  as.lighting = draws.light;
  as.shadows = draws.shadows ? Shadows::traced : Shadows::none;
  as.textures = draws.textures;
  as.texture_filter = TextureFilter::nearest;
  as.texture_wrap = TextureWrap::clamp;
  as.draw = Draw::filled;
  as.diffuse = true;
  if (rays && !draws.reflections) as.reflection_depth = 0;
  if (rays) as.specular = true;
  if (listing.listing->as_settings) listing.listing->as_settings(as);
  for (const std::string_view key : listing.listing->reads)
    if (const Option* option = find_option(key)) option->set(as, option->get(settings));
  // Listings know some values alone: the nearest texel or the four around a place; filled triangles with outlines or
  // without.
  if (listing_reads(listing, "texture-filter") && as.texture_filter != TextureFilter::bilinear)
    as.texture_filter = TextureFilter::nearest;
  if (listing_reads(listing, "draw") && as.draw != Draw::outlined) as.draw = Draw::filled;
  return as;
}

}  // namespace ps
