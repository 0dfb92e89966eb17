#include "hardware/stage_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frame/empty_frame.h"
#include "hardware/environment_maps.h"
#include "hardware/picture_drawer.h"
#include "hardware/render_hardware.h"
#include "hardware/shadow_maps.h"

namespace ps::hardware {
namespace {

RenderRequest stage_request() {
  RenderRequest request;
  request.channels = Channel::ids | Channel::depth | Channel::normal | Channel::uv;
  return request;
}

/// One drawing with its channels, what deferred shading keeps, and the depth buffer.
struct Drawing {
  Frame frame;
  Image<float> depth;
  std::array<Image<Vec4f>, GeometryBuffer::most_textures> kept;
};

/// A plan whose triangles have numbers, also those of spheres, and whose geometry buffer is kept. The depth test and
/// the limits are those of the picture.
PicturePlan keeping_plan(const Scene& scene, const View& view, Settings settings, Prepared& prepared,
                         Progress& progress) {
  settings.multisampling = 1;
  PicturePlan plan = make_plan(scene, view, settings, stage_request(), prepared);
  plan.shadow_maps = draw_maps(plan, prepared, WorkerPriority::normal, progress);
  plan.environment = draw_environment(plan, prepared, WorkerPriority::normal, progress);
  // The volumes themselves change no value of a surface; that they are counted changes how depths are limited.
  if (plan.counts_volumes)
    plan.volumes = std::make_shared<const std::vector<std::vector<raster::ShadowVolume>>>(plan.lights.size());
  for (raster::DrawObject& object : plan.objects) object.sphere = false;
  plan.defers = plan.only_geometry = true;
  return plan;
}

Drawing draw_kept(const PicturePlan& plan, const View& view) {
  Drawing drawing;
  drawing.frame = empty_frame<float>(view, stage_request());
  on_gl_thread([&](Workshop& shop) {
    shop.meshes.tidy();
    PictureDrawer drawer(plan, shop);
    drawer.upload();
    drawer.draw();
    shop.target->read(drawing.frame);
    drawing.depth = shop.target->read_depth();
    for (std::size_t i = 0; i < drawing.kept.size(); ++i) drawing.kept[i] = shop.geometry->read(i);
  });
  return drawing;
}

Image<Vec3f> three_of(const Image<Vec4f>& image) {
  Image<Vec3f> three(image.width(), image.height(), Unfilled{});
  std::transform(image.pixels().begin(), image.pixels().end(), three.pixels().begin(),
                 [](const Vec4f& v) { return Vec3f(v); });
  return three;
}

StageValues::Seen seen_of(Drawing& drawing) {
  return {std::move(drawing.frame.ids), std::move(drawing.frame.depth), std::move(drawing.depth)};
}

/// The picture's plan with a single triangle.
StageValues::Seen draw_alone(PicturePlan plan, const View& view, const PixelId& id) {
  const auto nothing = std::make_shared<const Mesh>();
  for (raster::DrawObject& object : plan.objects) {
    if (object.object != id.object || id.triangle < 0 ||
        static_cast<std::size_t>(id.triangle) >= object.mesh->triangles.size()) {
      object.mesh = nothing;
      continue;
    }
    Mesh one = *object.mesh;
    one.triangles = {object.mesh->triangles[static_cast<std::size_t>(id.triangle)]};
    object.mesh = std::make_shared<const Mesh>(std::move(one));
  }
  Drawing drawing = draw_kept(plan, view);
  for (PixelId& shown : drawing.frame.ids.pixels())
    if (shown.object >= 0) shown = id;
  return seen_of(drawing);
}

/// Which lights do not reach what is seen: those whose picture differs with and without shadows.
Image<std::uint32_t> lights_in_shadow(const Scene& scene, const View& view, const Settings& settings,
                                      Prepared& prepared, Progress& progress) {
  Image<std::uint32_t> in_shadow(view.width, view.height, 0u);
  const std::size_t lights = std::min<std::size_t>(scene.lights->size(), 32);
  for (std::size_t light = 0; light < lights; ++light) {
    if ((*scene.lights)[light].kind == LightKind::ambient) continue;
    Settings alone = settings;
    alone.multisampling = 1;
    alone.light_shown = static_cast<int>(light) + 1;
    const Frame dark = render_hardware(scene, view, alone, {}, prepared, progress);
    alone.shadows = Shadows::none;
    const Frame bright = render_hardware(scene, view, alone, {}, prepared, progress);
    for (std::size_t i = 0; i < dark.colour.pixels().size(); ++i)
      if (dark.colour.pixels()[i] != bright.colour.pixels()[i]) in_shadow.pixels()[i] |= 1u << light;
  }
  return in_shadow;
}

}  // namespace

std::shared_ptr<const StageValues> stage_values(const Scene& scene, const View& view, const Settings& settings,
                                                Prepared& prepared, Progress& progress) {
  const auto values = std::make_shared<StageValues>();
  if (!availability().driver) throw InputError(availability().reason);
  values->subpixel_bits = availability().driver->subpixel_bits;
  const PicturePlan plan = keeping_plan(scene, view, settings, prepared, progress);
  Drawing drawn = draw_kept(plan, view);
  values->seen = seen_of(drawn);
  values->larger_is_nearer = plan.depth.larger_is_nearer();
  values->draw_alone = [plan, view](const PixelId& id) { return draw_alone(plan, view, id); };
  values->surface = three_of(drawn.kept[0]);
  values->mapped_normal = three_of(drawn.kept[1]);
  values->shadow_maps = plan.shadow_maps;
  values->environment = plan.environment;
  const bool at_vertices = settings.lighting && settings.shading != Shading::phong;
  if (settings.lighting && !at_vertices) {
    values->specular = three_of(drawn.kept[3]);
    values->ambient = three_of(drawn.kept[4]);
  }
  progress.check();
  Settings plain = settings;
  plain.normal_mapping = false;
  plain.parallax = Parallax::off;
  plain.renormalise = false;
  const Drawing before_maps = draw_kept(keeping_plan(scene, view, plain, prepared, progress), view);
  values->normal = three_of(before_maps.kept[1]);
  values->position = three_of(before_maps.kept[2]);
  values->uv = before_maps.frame.uv;
  if (at_vertices && !plan.counts_volumes && !plan.maps_shadows) {  // else it is drawn light by light
    values->light = three_of(before_maps.kept[3]);
    values->extra = three_of(before_maps.kept[4]);
  }
  if (plan.counts_volumes) values->in_shadow = lights_in_shadow(scene, view, settings, prepared, progress);
  return values;
}

}  // namespace ps::hardware
