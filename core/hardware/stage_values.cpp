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

void draw_plan(const PicturePlan& plan, Workshop& shop) {
  shop.tidy();
  PictureDrawer drawer(plan, shop);
  drawer.upload();
  drawer.draw();
}

Drawing draw_kept(const PicturePlan& plan, const View& view) {
  Drawing drawing;
  drawing.frame = empty_frame<float>(view, stage_request());
  on_gl_thread([&](Workshop& shop) {
    draw_plan(plan, shop);
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

/// The smallest rectangle around the pixels that show something.
TileRect box_of(const Image<PixelId>& shown) {
  TileRect box{shown.width(), shown.height(), 0, 0};
  for (int y = 0; y < shown.height(); ++y)
    for (int x = 0; x < shown.width(); ++x) {
      if (shown.at(x, y).object < 0) continue;
      box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1), std::max(box.y1, y + 1)};
    }
  return box.x0 < box.x1 ? box : TileRect{0, 0, 0, 0};
}

/// The picture's plan with a single triangle.
StageValues::SeenAlone draw_alone(PicturePlan plan, const PixelId& id) {
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
  Image<PixelId> shown;
  Image<float> depth;
  on_gl_thread([&](Workshop& shop) {
    draw_plan(plan, shop);
    shown = shop.target->read_ids();
    depth = shop.target->read_depth();
  });
  StageValues::SeenAlone alone;
  alone.box = box_of(shown);
  alone.depth = Image<float>(alone.box.width(), alone.box.height(), -1.0f);
  for (int y = alone.box.y0; y < alone.box.y1; ++y)
    for (int x = alone.box.x0; x < alone.box.x1; ++x)
      if (shown.at(x, y).object >= 0) alone.depth.at(x - alone.box.x0, y - alone.box.y0) = depth.at(x, y);
  return alone;
}

float largest_part(const Vec3f& colour) {
  return std::max({std::abs(colour.x), std::abs(colour.y), std::abs(colour.z)});
}

/// Which lights do not reach what is seen: those whose picture loses light to shadows. Programs with and without
/// shadows may round the same light differently, so half of it must be gone.
Image<std::uint32_t> lights_in_shadow(const Scene& scene, const View& view, const Settings& settings,
                                      Prepared& prepared, Progress& progress) {
  Image<std::uint32_t> in_shadow(view.width, view.height, 0u);
  const std::size_t lights = std::min<std::size_t>(scene.lights->size(), 32);
  for (std::size_t light = 0; light < lights; ++light) {
    if ((*scene.lights)[light].kind == LightKind::ambient) continue;
    Settings alone = settings;
    alone.multisampling = 1;
    alone.light_shown = static_cast<int>(light);
    const Frame dark = render_hardware(scene, view, alone, {}, prepared, progress);
    alone.shadows = Shadows::none;
    const Frame bright = render_hardware(scene, view, alone, {}, prepared, progress);
    for (std::size_t i = 0; i < dark.colour.pixels().size(); ++i)
      if (largest_part(bright.colour.pixels()[i] - dark.colour.pixels()[i]) >
          largest_part(bright.colour.pixels()[i]) / 2)
        in_shadow.pixels()[i] |= 1u << light;
  }
  return in_shadow;
}

}  // namespace

std::shared_ptr<const StageValues> stage_values(const Scene& scene, const View& view, const Settings& settings,
                                                Prepared& prepared, Progress& progress) {
  const auto values = std::make_shared<StageValues>();
  values->subpixel_bits = require_driver(view).subpixel_bits;
  const PicturePlan plan = keeping_plan(scene, view, settings, prepared, progress);
  Drawing drawn = draw_kept(plan, view);
  values->seen = seen_of(drawn);
  values->larger_is_nearer = plan.depth.larger_is_nearer();
  values->draw_alone = [plan](const PixelId& id) { return draw_alone(plan, id); };
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
