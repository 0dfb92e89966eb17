#pragma once
#include <optional>
#include <vector>

#include "math/vec.h"
#include "options/settings.h"
#include "scene/light.h"
#include "scene/material.h"

namespace ps {

/// A light in the renderer's precision, converted once for each picture.
template <class Real>
struct ShadingLight {
  LightKind kind = LightKind::ambient;
  Real intensity = 1;
  Vec3<Real> colour{1, 1, 1};
  Vec3<Real> vector{0, 0, 0};  ///< position of a point light, direction towards a directional one; shading space
  Vec3<Real> attenuation{1, 0, 0};
  bool attenuates = false;
  Vec3<Real> specular_colour{1, 1, 1};
  Vec3<Real> ambient_colour{0, 0, 0};  ///< of light that a point or directional light adds everywhere
  bool adds_ambient = false;
  Real radius = 0;  ///< of a lamp
};

/// A material in the renderer's precision. Absent values as in Material.
template <class Real>
struct ShadingMaterial {
  Vec3<Real> colour{1, 1, 1};
  std::optional<Real> specular;
  Real reflective = 0;
  std::optional<Vec3<Real>> specular_colour;
  std::optional<Vec3<Real>> ambient_colour;
  Real transparency = 0;
  Real refraction_index = 1;
  int texture = -1;
  int normal_map = -1;
  int height_map = -1;
  int specular_map = -1;
  int ambient_map = -1;
  int opacity_map = -1;
  int reflection_map = -1;
  Surroundings surroundings = Surroundings::sphere;
  Real relief_depth = 0;

  /// Shadow rays pass what is transparent anywhere.
  bool passes_light() const { return transparency > 0 || opacity_map >= 0; }
  /// Whether maps decide about its light or opacity from point to point.
  bool varies() const { return specular_map >= 0 || ambient_map >= 0 || opacity_map >= 0; }
};

template <class Real>
inline ShadingLight<Real> shading_light(const Light& light) {
  const Vec3d vector = light.kind == LightKind::directional ? light.direction : light.position;
  return {light.kind,
          static_cast<Real>(light.intensity),
          Vec3<Real>(light.colour),
          Vec3<Real>(vector),
          Vec3<Real>(light.attenuation),
          light.attenuation != Vec3d{1, 0, 0},
          Vec3<Real>(highlight_colour(light)),
          Vec3<Real>(light.ambient_colour),
          light.ambient_colour != Vec3d(0),
          static_cast<Real>(light.radius)};
}

template <class Real>
inline ShadingMaterial<Real> shading_material(const Material& material) {
  ShadingMaterial<Real> result;
  result.colour = Vec3<Real>(material.colour);
  if (material.specular) result.specular = static_cast<Real>(*material.specular);
  result.reflective = static_cast<Real>(material.reflective);
  if (material.specular_colour) result.specular_colour = Vec3<Real>(*material.specular_colour);
  if (material.ambient_colour) result.ambient_colour = Vec3<Real>(*material.ambient_colour);
  result.transparency = static_cast<Real>(material.transparency);
  result.refraction_index = static_cast<Real>(material.refraction_index);
  result.texture = material.texture;
  result.normal_map = material.normal_map;
  result.height_map = material.height_map;
  result.specular_map = material.specular_map;
  result.ambient_map = material.ambient_map;
  result.opacity_map = material.opacity_map;
  result.reflection_map = material.reflection_map;
  result.surroundings = material.surroundings;
  const Vec3<Real> white(1);
  if (material.specular_map >= 0 && !material.specular_colour) result.specular_colour = white;
  if (material.ambient_map >= 0 && !material.ambient_colour) result.ambient_colour = white;
  result.relief_depth = static_cast<Real>(material.relief_depth);
  return result;
}

/// `shown` (option light-shown) is the index of the light beside which all are dark, or all_lights.
template <class Real>
inline std::vector<ShadingLight<Real>> shading_lights(const std::vector<Light>& lights, int shown) {
  std::vector<ShadingLight<Real>> result;
  result.reserve(lights.size());
  for (const Light& light : lights) {
    const bool dark = shown != all_lights && static_cast<int>(result.size()) != shown;
    result.push_back(shading_light<Real>(light));
    if (dark) result.back().intensity = 0;
  }
  return result;
}

template <class Real>
inline std::vector<ShadingMaterial<Real>> shading_materials(const std::vector<Material>& materials) {
  std::vector<ShadingMaterial<Real>> result;
  result.reserve(materials.size());
  for (const Material& material : materials) result.push_back(shading_material<Real>(material));
  return result;
}

}  // namespace ps
