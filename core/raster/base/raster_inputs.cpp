#include "raster/base/raster_inputs.h"

#include "raster/base/fast_path.h"
#include "raster/base/multisample.h"

namespace ps::raster {

template <class Real>
RasterInputs<Real> make_raster_inputs(const Scene& scene, const View& view, const Settings& settings, Channel channels,
                                      Prepared& prepared) {
  RasterInputs<Real> inputs;
  inputs.scene = &scene;
  inputs.settings = settings;
  inputs.channels = channels;
  inputs.viewport = make_viewport<double>(view, settings);
  inputs.projection = make_canvas_projection<Real>(inputs.viewport);
  inputs.camera_space = make_camera_space(view.camera);
  inputs.camera = view.camera;
  inputs.eye = Vec3<Real>(view.camera.position);
  inputs.backward = Vec3<Real>(-view.camera.forward);
  inputs.planes = make_clip_planes<Real>(settings, inputs.viewport);
  inputs.grid = {settings.subpixel_bits, settings.fill_rule, inputs.viewport.sample,
                 settings.draw == Draw::outlined ? 1 : sample_count(settings.multisampling)};
  inputs.coverage = {settings.coverage, settings.edge_arithmetic};
  inputs.depth = make_depth_code(settings, inputs.viewport.distance);
  inputs.lights = shading_lights<Real>(*scene.lights, settings.light_shown);
  inputs.objects = make_draw_list(scene, view, settings, inputs.viewport, prepared);
  Surfaces<Real> surfaces = make_surfaces<Real>(scene, inputs.objects, settings, channels);
  inputs.first_surface = std::move(surfaces.first);
  inputs.surfaces = std::move(surfaces.list);
  if (surfaces.textured) inputs.textures = mip_chains(scene, settings.texture_filter, prepared);
  inputs.path = rasterized_fast_path(settings, prepared_traits(scene, prepared), channels);
  return inputs;
}

template RasterInputs<float> make_raster_inputs(const Scene&, const View&, const Settings&, Channel, Prepared&);
template RasterInputs<double> make_raster_inputs(const Scene&, const View&, const Settings&, Channel, Prepared&);

}  // namespace ps::raster
