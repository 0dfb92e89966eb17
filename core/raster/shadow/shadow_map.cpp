#include "raster/shadow/shadow_map.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/available_memory.h"
#include "math/unit.h"
#include "options/renderer_kind.h"
#include "raster/setup/draw_list.h"
#include "raster/shadow/draw_maps.h"

namespace ps::raster {
namespace {

constexpr double nearest_caster = 1e-3;  // world units in front of a light; nothing nearer casts a shadow
constexpr double dwarfing = 30;          // an object so much larger than all smaller ones together is a ground
constexpr double margin_texels = 2;      // outlines stay clear of the square's border

/// Only what decides depth; everything else at its default or off.
Settings map_settings(const Settings& settings, bool cube) {
  Settings plain;
  plain.renderer = Renderer::rasterizer;
  plain.projection = cube ? Projection::perspective : Projection::orthographic;
  plain.near = nearest_caster;
  plain.backface_culling = false;  // rays are stopped by both sides
  plain.lighting = false;
  plain.textures = false;
  plain.shadows = Shadows::none;
  plain.tessellation = settings.tessellation;
  plain.patches = settings.patches;
  plain.threads = settings.threads;
  plain.simd = settings.simd;
  return plain;
}

/// The scene with only the objects that cast shadows, to save time.
Scene dense_part(const Scene& scene) {
  Scene dark = scene;
  dark.canvas_items = {};
  dark.geometry.edit([&](Geometry& geometry) {
    std::erase_if(geometry.objects, [&](const Object& object) { return !throws_shadow(scene, object); });
  });
  return dark;
}

ShadowMap point_map(const Scene& scene, const Light& light, const Settings& settings, const DrawDepth& draw_depth) {
  ShadowMap map;
  map.size = settings.shadow_map_size;
  map.cube = true;
  map.position = light.position;
  for (const CubeFace& face : cube_faces())
    map.faces.push_back(
        draw_depth(scene, {cube_camera(face, light.position), map.size, map.size}, map_settings(settings, true)));
  return map;
}

/// Everything but the depths.
ShadowMap frame_around(const ShadowCasters& casters, const Light& light, int size) {
  ShadowMap map;
  map.size = size;
  map.frame.forward = -unit_of(light.direction);
  const Vec3d& forward = map.frame.forward;
  const Vec3d other = std::abs(forward.y) < 0.9 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
  const Vec3d right = cross(other, forward);
  map.frame.right = unit_of(right);
  map.frame.up = cross(forward, map.frame.right);
  // The square around them as the light sees them. Spheres are rounder than their triangles here.
  Vec3d low(1e300), high(-1e300);
  const auto reach = [&](const Vec3d& p, double radius) {
    const Vec3d local = in_face(map.frame, p);
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], local[axis] - radius);
      high[axis] = std::max(high[axis], local[axis] + radius);
    }
  };
  for (const DrawObject& object : casters.objects) {
    if (object.sphere)
      reach(object.bounds.centre, object.bounds.radius);
    else
      for (const Vec3d& p : object.mesh->positions) reach(object.world(p), 0);
  }
  if (casters.objects.empty()) low = Vec3d(-1), high = Vec3d(1);
  const Vec3d middle = (low + high) * 0.5;
  map.half = std::max({high.x - middle.x, high.y - middle.y, 1e-6}) * (1 + 2 * margin_texels / map.size);
  const double start = low.z - 0.01 * (high.z - low.z) - 2 * nearest_caster;
  map.position = map.frame.right * middle.x + map.frame.up * middle.y + forward * start;
  return map;
}

ShadowMap directional_map(const Scene& scene, const ShadowCasters& casters, const Light& light,
                          const Settings& settings, const DrawDepth& draw_depth) {
  ShadowMap map = frame_around(casters, light, settings.shadow_map_size);
  Camera camera = cube_camera(map.frame, map.position);
  camera.viewport_width = camera.viewport_height = 2 * map.half;
  map.faces.push_back(draw_depth(scene, {camera, map.size, map.size}, map_settings(settings, false)));
  return map;
}

}  // namespace

std::uint64_t shadow_map_bytes(const std::vector<Light>& lights, int size) {
  const std::uint64_t face = sizeof(float) * static_cast<std::uint64_t>(size) * static_cast<std::uint64_t>(size);
  std::uint64_t faces = 0;
  for (const Light& light : lights)
    faces += light.kind == LightKind::point ? 6 : light.kind == LightKind::directional ? 1 : 0;
  constexpr std::uint64_t while_drawn = 6;  // floats for each texel of the picture whose depth becomes a face
  return face * (faces + while_drawn);
}

bool uses_shadow_maps(const Settings& settings, const Scene& scene) {
  const bool fills_surfaces = !draws_fragments(settings.renderer) || fills(settings.draw);
  return settings.shadows == Shadows::map && settings.lighting && fills_surfaces && scene_traits(scene).casting_lights;
}

bool throws_shadow(const Scene& scene, const Object& object) {
  const auto dense = [&](std::uint32_t material) {
    const Material& of_part = scene.materials->at(material);
    return !(of_part.transparency > 0) && of_part.opacity_map < 0;
  };
  if (const auto* sphere = std::get_if<Sphere>(&object.shape)) return dense(sphere->material);
  if (const auto* solid = std::get_if<Solid>(&object.shape)) return dense(solid->material);
  const auto* instance = std::get_if<Instance>(&object.shape);
  if (!instance) return false;
  if (instance->material) return dense(*instance->material);
  const auto& slots = scene.geometry->meshes.at(instance->mesh)->materials;
  return std::any_of(slots.begin(), slots.end(), dense);
}

ShadowCasters shadow_casters(const Scene& scene) {
  Prepared own;
  Settings coarse;
  coarse.tessellation = 50;
  const View anywhere{scene.camera, 64, 64};
  ShadowCasters casters;
  for (DrawObject& object : make_draw_list(scene, anywhere, coarse, make_viewport<double>(anywhere, coarse), own)) {
    const auto* solid = std::get_if<Solid>(&scene.geometry->objects[static_cast<std::size_t>(object.object)].shape);
    if (object.mesh->triangles.empty() || (solid && form_name(solid->form) == "plane")) continue;
    const bool flat_sides = solid && (form_name(solid->form) == "box" || form_name(solid->form) == "rectangle");
    object.sphere = object.sphere && !flat_sides;  // from here on: is it rounder than its triangles?
    casters.objects.push_back(std::move(object));
  }
  std::stable_sort(casters.objects.begin(), casters.objects.end(),
                   [](const auto& a, const auto& b) { return a.bounds.radius < b.bounds.radius; });
  Vec3d low(0), high(0);
  for (std::size_t i = 0; i < casters.objects.size(); ++i) {
    const BoundingSphere& ball = casters.objects[i].bounds;
    if (i > 0 && casters.radius * dwarfing < ball.radius) {
      casters.objects.resize(i);
      break;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double from = ball.centre[axis] - ball.radius, to = ball.centre[axis] + ball.radius;
      low[axis] = i == 0 ? from : std::min(low[axis], from);
      high[axis] = i == 0 ? to : std::max(high[axis], to);
    }
    casters.centre = (low + high) * 0.5;
    const Vec3d across = high - casters.centre;
    casters.radius = std::max(length_of(across), 1e-6);
  }
  return casters;
}

ShadowMap empty_directional_map(const Scene& scene, const Light& light, int size) {
  return frame_around(shadow_casters(dense_part(scene)), light, size);
}

ShadowMaps draw_shadow_maps(const Scene& scene, const Settings& settings, const DrawDepth& draw_depth) {
  const auto casting = std::count_if(scene.lights->begin(), scene.lights->end(),
                                     [](const Light& light) { return light.kind != LightKind::ambient; });
  require_memory(shadow_map_bytes(*scene.lights, settings.shadow_map_size), available_memory(),
                 fmt::format("the shadow maps of {} lights with {} x {} texels", casting, settings.shadow_map_size,
                             settings.shadow_map_size),
                 "set a smaller 'shadow-map-size', or have fewer lights");
  const Scene dark = dense_part(scene);
  const ShadowCasters casters = shadow_casters(dark);
  ShadowMaps maps;
  for (const Light& light : *scene.lights) {
    switch (light.kind) {
    case LightKind::ambient:
      maps.emplace_back();
      break;
    case LightKind::point:
      maps.push_back(point_map(dark, light, settings, draw_depth));
      break;
    case LightKind::directional:
      maps.push_back(directional_map(dark, casters, light, settings, draw_depth));
      break;
    }
  }
  return maps;
}

Key shadow_maps_key(std::string_view product, const Scene& scene, const Settings& settings) {
  return Key(product)
      .add(scene.geometry.revision())
      .add(scene.lights.revision())
      .add(scene.materials.revision())
      .add(std::uint64_t(settings.shadow_map_size))
      .add(settings.tessellation)
      .add(settings.patches);
}

}  // namespace ps::raster
