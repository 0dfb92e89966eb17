#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "base/check.h"
#include "math/unit.h"
#include "scene/float_limits.h"

namespace ps {
namespace {

/// A smaller transparency is not seen: it only keeps a surface from casting a shadow.
constexpr double least_transparency = 1.0 / 1024;

void note_material(const Material& material, SceneTraits& traits) {
  traits.reflective = traits.reflective || material.reflective > 0;
  traits.specular = traits.specular || material.specular.has_value();
  traits.textures = traits.textures || material.texture >= 0;
  traits.normal_maps = traits.normal_maps || material.normal_map >= 0;
  traits.height_maps = traits.height_maps || material.height_map >= 0;
  const bool light_maps = material.specular_map >= 0 || material.ambient_map >= 0;
  traits.light_maps = traits.light_maps || light_maps;
  traits.opacity_maps = traits.opacity_maps || material.opacity_map >= 0;
  traits.reflection_maps = traits.reflection_maps || (material.reflection_map >= 0 && material.reflective > 0);
  traits.mirrors = traits.mirrors || (material.reflection_map < 0 && material.reflective > 0);
  traits.textures = traits.textures || light_maps || material.opacity_map >= 0 || material.reflection_map >= 0;
  traits.transparent = traits.transparent || material.transparency >= least_transparency || material.opacity_map >= 0;
  traits.any_transparency = traits.any_transparency || material.transparency > 0 || material.opacity_map >= 0;
  traits.tinted = traits.tinted || material.ambient_colour || material.specular_colour || light_maps;
  const bool usual = !material.specular || (*material.specular > 0 && std::isfinite(*material.specular));
  traits.odd_highlights = traits.odd_highlights || !usual;
}

}  // namespace

SceneTraits scene_traits(const Scene& scene) {
  SceneTraits traits;
  const auto& materials = *scene.materials;
  for (const Object& object : scene.geometry->objects) {
    traits.dynamic = traits.dynamic || object.dynamic;
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
      traits.spheres = true;
      ++traits.sphere_count;
      note_material(materials.at(sphere->material), traits);
      continue;
    }
    if (const auto* solid = std::get_if<Solid>(&object.shape)) {
      traits.solids = true;
      traits.stretched = traits.stretched || !solid->place.is_identity();
      note_material(materials.at(solid->material), traits);
      continue;
    }
    if (const auto* csg = std::get_if<Csg>(&object.shape)) {
      traits.csg = true;
      for (const Solid* part : csg_parts(csg->root)) {
        note_material(materials.at(part->material), traits);
        traits.stretched = traits.stretched || !part->place.is_identity();
      }
      continue;
    }
    const auto& instance = std::get<Instance>(object.shape);
    const Mesh& mesh = *scene.geometry->meshes.at(instance.mesh);
    const Vec3d& scale = instance.transform.scale;
    traits.stretched = traits.stretched || scale.x != scale.y || scale.y != scale.z;
    traits.triangles = traits.triangles || !mesh.triangles.empty();
    traits.one_sided = traits.one_sided || instance.sides == Sides::front;
    traits.patches = traits.patches || !mesh.patches.empty();
    traits.vertex_normals = traits.vertex_normals || !mesh.normals.empty();
    if (instance.material) {
      note_material(materials.at(*instance.material), traits);
    } else {
      for (const auto slot : mesh.materials) note_material(materials.at(slot), traits);
    }
  }
  traits.casting_lights = std::any_of(scene.lights->begin(), scene.lights->end(),
                                      [](const Light& light) { return light.kind != LightKind::ambient; });
  traits.point_lights = std::any_of(scene.lights->begin(), scene.lights->end(),
                                    [](const Light& light) { return light.kind == LightKind::point; });
  traits.attenuated = std::any_of(scene.lights->begin(), scene.lights->end(), [](const Light& light) {
    return light.kind == LightKind::point && light.attenuation != Vec3d{1, 0, 0};
  });
  traits.light_count = scene.lights->size();
  const FloatLimits limits = float_limits(scene);
  traits.outgrows_float = limits.detail;
  traits.rounds_places = limits.detail || limits.places;
  traits.light_at_surface = limits.light_at_surface;
  for (std::size_t i = 0; i < scene.lights->size(); ++i) {
    const Light& light = (*scene.lights)[i];
    if (light.intensity == 0) continue;
    traits.coloured_lights = traits.coloured_lights || light.colour != Vec3d(1) || has_term_colours(light);
    traits.term_colours = traits.term_colours || has_term_colours(light);
    traits.lamps = traits.lamps || light.radius > 0;
    if (light.colour != Vec3d(0) || has_term_colours(light))
      traits.shining_lights |= 1u << std::min<std::size_t>(i, 31);
  }
  traits.canvas_items = !scene.canvas_items->empty();
  traits.canvas_triangles =
      std::any_of(scene.canvas_items->begin(), scene.canvas_items->end(),
                  [](const CanvasItem& item) { return !std::holds_alternative<CanvasLine>(item); });
  for (const CanvasItem& item : lines_and_triangles(*scene.canvas_items)) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    if (!triangle || !triangle->filled) continue;
    const auto& [c0, c1, c2] = triangle->colours;
    traits.canvas_intensities = traits.canvas_intensities || triangle->h != std::array<double, 3>{1, 1, 1};
    traits.canvas_gradients = traits.canvas_gradients || c0 != c1 || c0 != c2;
  }
  return traits;
}

const Material& material_of(const Scene& scene, int object, int triangle) {
  const Object& thing = scene.geometry->objects.at(static_cast<std::size_t>(object));
  if (const auto* sphere = std::get_if<Sphere>(&thing.shape)) return scene.materials->at(sphere->material);
  if (const auto* solid = std::get_if<Solid>(&thing.shape)) return scene.materials->at(solid->material);
  if (const auto* csg = std::get_if<Csg>(&thing.shape))
    return scene.materials->at(csg_parts(csg->root).at(static_cast<std::size_t>(triangle))->material);
  const auto& instance = std::get<Instance>(thing.shape);
  if (instance.material) return scene.materials->at(*instance.material);
  const Mesh& mesh = *scene.geometry->meshes.at(instance.mesh);
  return scene.materials->at(mesh.materials.at(mesh.triangles.at(static_cast<std::size_t>(triangle)).material));
}

BoundingSphere bounding_sphere(const Mesh& mesh) {
  if (mesh.triangles.empty()) return {};
  std::vector<char> is_used(mesh.positions.size(), 0);
  for (const MeshTriangle& triangle : mesh.triangles)
    for (const std::uint32_t position : triangle.position) is_used[position] = 1;
  Vec3d low = mesh.positions[mesh.triangles.front().position[0]];
  Vec3d high = low;
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    const Vec3d& p = mesh.positions[i];
    for (int axis = 0; is_used[i] != 0 && axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  BoundingSphere sphere{(low + high) * 0.5, 0};
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i] != 0) sphere.radius = std::max(sphere.radius, length_of(mesh.positions[i] - sphere.centre));
  }
  return sphere;
}

}  // namespace ps
