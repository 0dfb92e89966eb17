#include "hardware/picture_plan.h"

#include <algorithm>
#include <bit>

#include "raster/setup/draw_stage.h"
#include "raster/setup/textures.h"

namespace ps::hardware {
namespace {

double farthest_of(const PicturePlan& plan) {
  double farthest = plan.depth.near * 2;
  for (const raster::DrawObject& object : plan.objects) {
    const double z = plan.camera_space.point(object.bounds.centre).z + object.bounds.radius;
    farthest = std::max(farthest, z * (1 + 1e-6));
  }
  return plan.depth.far > 0 ? std::min(farthest, plan.depth.far) : farthest;
}

}  // namespace

PicturePlan make_plan(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                      Prepared& prepared) {
  PicturePlan plan;
  plan.scene = &scene;
  plan.camera = view.camera;
  plan.settings = settings;
  plan.settings.deferred_shading = false;  // lacks.h
  plan.channels = request.channels;
  plan.viewport = make_viewport<double>(view, settings);
  plan.projection = raster::make_canvas_projection<double>(plan.viewport);
  plan.camera_space = raster::make_camera_space(view.camera);
  plan.depth = raster::make_depth_code(settings, plan.viewport.distance);
  plan.objects = raster::make_draw_list(scene, view, settings, plan.viewport, prepared);
  plan.surfaces = raster::make_surfaces<float>(scene, plan.objects, settings, request.channels);
  plan.lights = shading_lights<float>(*scene.lights, settings.light_shown);
  if (plan.surfaces.textured) plan.textures = raster::mip_chains(scene, settings.texture_filter, prepared);
  plan.maps_shadows = raster::uses_shadow_maps(settings, scene) && settings.shading == Shading::phong;
  plan.farthest = farthest_of(plan);
  plan.region = request.region;
  return plan;
}

int sample_count(const Settings& settings) {
  if (settings.draw != Draw::filled) return 1;
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::clamp(settings.multisampling, 1, 8))));
}

bool draws_in_passes(const PicturePlan& plan) {
  return raster::draw_steps(plan.settings, plan.lights.size()).size() > 1;
}

bool driver_keeps_depth(const PicturePlan& plan, bool clip_control) {
  if (plan.settings.visibility != Visibility::depth_buffer) return true;  // none is kept
  if (!clip_control || !plan.perspective() || plan.depth.value != DepthValue::inverse_z) return false;
  if (plan.depth.format != DepthFormat::unorm || plan.depth.bits == 24) return true;
  return plan.depth.bits == 16 && !draws_in_passes(plan);  // no driver keeps a stencil beside 16 bits
}

}  // namespace ps::hardware
