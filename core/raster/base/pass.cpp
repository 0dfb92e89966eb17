#include "raster/base/pass.h"

#include "raster/base/fast_path.h"
#include "raster/base/multisample.h"

namespace ps::raster {

template <class Real>
Pass<Real> make_pass(const Scene& scene, const View& view, const Settings& settings, Channel channels,
                     Prepared& prepared) {
  Pass<Real> pass;
  pass.scene = &scene;
  pass.settings = settings;
  pass.channels = channels;
  pass.viewport = make_viewport<double>(view, settings);
  pass.projection = make_canvas_projection<Real>(pass.viewport);
  pass.camera_space = make_camera_space(view.camera);
  pass.camera = view.camera;
  pass.eye = Vec3<Real>(view.camera.position);
  pass.backward = Vec3<Real>(-view.camera.forward);
  pass.planes = make_clip_planes<Real>(settings, pass.viewport);
  pass.grid = {settings.subpixel_bits, settings.fill_rule, pass.viewport.sample, sample_count(settings.multisampling)};
  pass.coverage = {settings.coverage, settings.edge_arithmetic};
  pass.depth = make_depth_code(settings, pass.viewport.distance);
  pass.lights = shading_lights<Real>(*scene.lights, settings.light_shown);
  pass.objects = make_draw_list(scene, view, settings, pass.viewport, prepared);
  Surfaces<Real> surfaces = make_surfaces<Real>(scene, pass.objects, settings, channels);
  pass.first_surface = std::move(surfaces.first);
  pass.surfaces = std::move(surfaces.list);
  if (surfaces.textured) pass.textures = mip_chains(scene, settings.texture_filter, prepared);
  pass.path = rasterized_fast_path(settings, prepared_traits(scene, prepared), channels);
  return pass;
}

template Pass<float> make_pass(const Scene&, const View&, const Settings&, Channel, Prepared&);
template Pass<double> make_pass(const Scene&, const View&, const Settings&, Channel, Prepared&);

}  // namespace ps::raster
