// What the shadow methods of triangles look like from outside: silhouettes and volumes, and what shadow maps cover.
#include <algorithm>

#include "inspect/space_parts.h"
#include "options/renderer_kind.h"
#include "raster/shadow/cube_face.h"
#include "raster/shadow/shadow_map.h"
#include "raster/shadow/shadow_volume.h"
#include "render/story/names.h"

namespace ps {
namespace {

constexpr std::size_t most_triangles = 50000;  // of a model whose outline is drawn
constexpr double shown_length = 2.5;           // of the sides, in radii of what is worth seeing
constexpr double cube_size = 0.12;             // of a point light's cube, likewise

void add_volume(const raster::ShadowVolume& volume, const Light& light, double length, SpaceModel& model) {
  const auto away = [&](const Vec3d& p) {
    const Vec3d from = light.kind == LightKind::point ? p - light.position : -light.direction;
    const double size = std::sqrt(dot(from, from));
    return size > 0 ? p + from * (length / size) : p;
  };
  for (const raster::SilhouetteEdge& edge : volume.silhouette) {
    model.items.push_back({SpaceKind::silhouette, SpaceShape::line, {edge.from, edge.to}});
    model.items.push_back(
        {SpaceKind::shadow_volume, SpaceShape::area, {edge.to, edge.from, away(edge.from), away(edge.to)}});
  }
}

void add_volumes(const SpaceInputs& inputs, SpaceModel& model) {
  Prepared own;
  const auto viewport = make_viewport<double>(inputs.view, inputs.settings);
  const auto objects = raster::make_draw_list(inputs.scene, inputs.view, inputs.settings, viewport, own);
  double length = shown_length * inputs.bounds.radius;
  if (inputs.settings.volume_length > 0) length = std::min(length, inputs.settings.volume_length);
  for (const Light& light : *inputs.scene.lights) {
    if (light.kind == LightKind::ambient) continue;
    for (const raster::DrawObject& object : objects) {
      const auto index = static_cast<std::size_t>(object.object);
      if (object.mesh->triangles.size() > most_triangles || model.ground[index]) continue;
      if (!raster::throws_shadow(inputs.scene, inputs.scene.geometry->objects[index])) continue;
      const raster::ShadowVolume volume = raster::make_shadow_volume(object, light, {.reach = inputs.bounds.radius});
      add_volume(volume, light, length, model);
    }
  }
}

/// The outline of a square across `frame`, at `z` before `position`.
std::vector<Vec3d> square(const raster::CubeFace& frame, const Vec3d& position, double half, double z) {
  const Vec3d middle = position + frame.forward * z;
  const Vec3d right = frame.right * half, up = frame.up * half;
  return {middle - right + up, middle + right + up, middle + right - up, middle - right - up};
}

/// A point light's cube, or the square beam of a directional one.
void add_map(const SpaceInputs& inputs, const Light& light, const std::string& name, SpaceModel& model) {
  if (light.kind == LightKind::point) {
    const double half = cube_size * inputs.bounds.radius;
    for (const raster::CubeFace& face : raster::cube_faces())
      model.items.push_back({SpaceKind::shadow_map, SpaceShape::outline, square(face, light.position, half, half)});
  } else {
    const raster::ShadowMap map = raster::empty_directional_map(inputs.scene, light, inputs.settings.shadow_map_size);
    const auto start = square(map.frame, map.position, map.half, 0);
    const auto end = square(map.frame, map.position, map.half, 2 * raster::shadow_casters(inputs.scene).radius);
    model.items.push_back({SpaceKind::shadow_map, SpaceShape::outline, start});
    model.items.push_back({SpaceKind::shadow_map, SpaceShape::outline, end});
    for (std::size_t i = 0; i < 4; ++i)
      model.items.push_back({SpaceKind::shadow_map, SpaceShape::line, {start[i], end[i]}});
  }
  model.items.back().label = "shadow map of " + name;
}

}  // namespace

void add_shadow_methods(const SpaceInputs& inputs, SpaceModel& model) {
  if (runs_listing(inputs.settings.renderer) || !inputs.settings.lighting) return;
  switch (inputs.settings.shadows) {
  case Shadows::traced:
  case Shadows::none:
    return;
  case Shadows::stencil_depth_fail:
  case Shadows::stencil_depth_pass:
    if (draws_fragments(inputs.settings.renderer)) add_volumes(inputs, model);
    return;
  case Shadows::map:
    for (std::size_t i = 0; i < inputs.scene.lights->size(); ++i)
      if (const Light& light = (*inputs.scene.lights)[i]; light.kind != LightKind::ambient)
        add_map(inputs, light, light_name(inputs.scene, static_cast<int>(i)), model);
    return;
  }
}

}  // namespace ps
