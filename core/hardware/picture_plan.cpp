#include "hardware/picture_plan.h"

#include <algorithm>
#include <bit>

#include "frame/fast_kernels.h"
#include "hardware/draw_passes.h"
#include "raster/setup/draw_stage.h"
#include "raster/setup/textures.h"
#include "raster/shadow/stencil.h"

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
  plan.channels = request.channels;
  plan.viewport = make_viewport<double>(view, settings);
  plan.projection = raster::make_canvas_projection<double>(plan.viewport);
  plan.camera_space = raster::make_camera_space(view.camera);
  plan.depth = raster::make_depth_code(settings, plan.viewport.distance);
  plan.objects = raster::make_draw_list(scene, view, settings, plan.viewport, prepared);
  plan.surfaces = raster::make_surfaces<float>(scene, plan.objects, settings, request.channels);
  plan.lights = shading_lights<float>(*scene.lights, settings.light_shown);
  if (plan.surfaces.textured) plan.textures = raster::mip_chains(scene, settings.texture_filter, prepared);
  plan.maps_shadows = raster::uses_shadow_maps(settings, scene);
  plan.counts_volumes = raster::uses_stencil(settings, scene);
  plan.mirrors = raster::uses_environment(settings, scene);
  plan.term_colours = prepared_traits(scene, prepared).term_colours;
  // A picture of the surroundings is read where its surface is drawn, which the shading of the whole picture is not.
  const bool pictures = std::any_of(plan.surfaces.list.begin(), plan.surfaces.list.end(),
                                    [&](const auto& surface) { return reflects_picture(plan, surface); });
  plan.defers =
      raster::defers_shading(settings) && !pictures && (settings.shading == Shading::phong || !lights_separately(plan));
  plan.exact_places = prepared_traits(scene, prepared).light_at_surface && !plan.affine();
  plan.farthest = farthest_of(plan);
  plan.region = request.region;
  return plan;
}

Vec3d camera_position(const PicturePlan& plan, const Vec3d& world) {
  if (plan.settings.camera_relative) return plan.camera_space.point(world);
  return plan.camera_space.from_world * Vec3d(Vec3f(world) - Vec3f(plan.camera_space.position));
}

int sample_count(const Settings& settings) {
  if (settings.draw != Draw::filled) return 1;
  return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::clamp(settings.multisampling, 1, 8))));
}

Vec2d shifted_centre(const PicturePlan& plan) { return plan.projection.centre + Vec2d(0.5) - plan.viewport.sample; }

bool mirrors(const PicturePlan& plan, const raster::Surface<float>& surface) {
  const raster::AttributeLayout& layout = surface.layout;
  return plan.mirrors && surface.material.reflective > 0 && !layout.reflection_map &&
         layout.position != raster::AttributeLayout::absent;
}

bool reflects_picture(const PicturePlan& plan, const raster::Surface<float>& surface) {
  return fills(plan.settings.draw) && surface.layout.reflection_map;
}

bool driver_keeps_depth(const PicturePlan& plan, bool clip_control) {
  if (plan.settings.visibility != Visibility::depth_buffer) return true;  // none is kept
  if (!clip_control || !plan.perspective() || plan.depth.value != DepthValue::inverse_z) return false;
  if (plan.depth.format != DepthFormat::unorm || plan.depth.bits == 24) return true;
  return plan.depth.bits == 16 && draw_passes(plan).size() == 1;  // no driver keeps a stencil beside 16 bits
}

}  // namespace ps::hardware
