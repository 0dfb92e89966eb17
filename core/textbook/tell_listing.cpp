#include "textbook/tell_listing.h"

#include "options/renderer_kind.h"
#include "textbook/tell_parts.h"

namespace ps {
namespace {

/// The chapter that a listing belongs to: "cgfs_04_shadows_and_reflections" is 4.
int chapter_of(const NamedListing& listing) {
  int chapter = 0;
  for (const char c : listing.folder.substr(listing.folder.find('_') + 1, 2)) chapter = 10 * chapter + (c - '0');
  return chapter;
}

constexpr int first_with_light = 3, first_with_shadows = 4, first_raster = 6, scenes_chapter = 10, hidden_surfaces = 12,
              shading_chapter = 13, textures_chapter = 14;

}  // namespace

std::vector<Event> tell_listing(const BookScene& book, const ListingTrace& trace) {
  const textbook::WatchReader reader(trace);
  PixelRecorder recorder(trace.pixel);
  const int chapter = chapter_of(trace.listing);
  if (sends_rays(way_of(trace.listing)))
    textbook::tell_rays(book, reader, recorder);
  else if (chapter < scenes_chapter)
    textbook::tell_canvas_items(book, reader, recorder);
  else
    textbook::tell_triangles(book, reader, recorder);
  return recorder.take();
}

Renderer way_of(const NamedListing& listing) {
  return listing.listing->order == ListingOrder::pixel_by_pixel ? Renderer::ray_tracer : Renderer::rasterizer;
}

Settings settings_as_listed(const NamedListing& listing, const Scene& scene, const Settings& settings) {
  const int chapter = chapter_of(listing);
  Settings as = settings;
  as.renderer = way_of(listing);
  as.precision = Precision::float64;
  as.sample_position = SamplePosition::corner;
  as.samples_per_pixel = as.multisampling = as.subsampling = as.anisotropy = 1;
  as.adaptive_sampling = false;
  as.projection = Projection::perspective;
  as.viewport_fit = ViewportFit::height;
  as.sphere_test = SphereTest::quadratic;
  as.self_hit = SelfHit::epsilon;
  as.epsilon_unit = EpsilonUnit::ray_parameter;
  as.illumination = Illumination::book;
  as.highlight = Highlight::phong;
  as.light_shown = 0;
  as.refraction = false;
  for (const Material& material : *scene.materials)
    if (material.normal_map >= 0) as.normal_mapping = false;
  as.parallax = Parallax::off;
  as.environment = Environment::none;
  as.subpixel_bits = 0;
  as.fill_rule = FillRule::inclusive;
  as.line_algorithm = LineAlgorithm::interpolate;
  as.clipping = Clipping::none;
  const bool rays = chapter < first_raster;
  as.lighting = rays ? chapter >= first_with_light : chapter >= shading_chapter;
  as.shadows = rays && chapter >= first_with_shadows ? Shadows::traced : Shadows::none;
  if (chapter < first_with_shadows) as.reflection_depth = 0;
  as.textures = chapter >= textures_chapter;
  as.texture_filter = TextureFilter::nearest;
  as.texture_wrap = TextureWrap::clamp;
  as.draw = chapter == scenes_chapter ? Draw::wireframe : Draw::filled;
  if (chapter >= shading_chapter) as.backface_culling = true;
  if (chapter > hidden_surfaces) as.visibility = Visibility::depth_buffer;
  if (rays) as.specular = true;
  if (chapter == shading_chapter) as.interpolation = Interpolation::affine;
  if (chapter >= textures_chapter) {
    as.shading = Shading::phong;
    as.normals = Normals::vertex;
  }
  return as;
}

}  // namespace ps
