#pragma once
#include <optional>
#include <string>

#include "math/vec.h"

namespace ps {

/// How a picture shows all surroundings (shade/reflection_map.h): a map of the world, or the cross of a folded-out
/// cube.
enum class Surroundings { sphere, cube };

/// The optical properties of a surface. Colours are linear, 1.0 = the book's 255.
struct Material {
  std::string name;
  Vec3d colour{1, 1, 1};
  std::optional<double> specular;        ///< exponent of the highlight; absent = matte (the book's -1)
  double reflective = 0;                 ///< share of reflected light, 0..1
  std::optional<Vec3d> specular_colour;  ///< absent: the highlight takes `colour`, as in the book's equation
  std::optional<Vec3d> ambient_colour;   ///< absent: ambient light takes `colour`
  double transparency = 0;               ///< share of light that comes through, 0..1; casts no shadow if above 0
  double refraction_index = 1;           ///< of what is inside (CGFS ch. 5); vacuum has 1
  int texture = -1;  ///< index into Scene::textures; its texels are multiplied by `colour`; -1 = none
  int normal_map =
      -1;  ///< index into Scene::textures: red, green, blue = tangent-space x, y, z from -1 to 1; -1 = none
  int height_map = -1;    ///< index into Scene::textures: red from 0, the bottom of a relief, to 1, its top; -1 = none
  int specular_map = -1;  ///< multiplies the highlight's colour, which is white without `specular_colour`; -1 = none
  int ambient_map = -1;   ///< multiplies the colour of ambient light, white without `ambient_colour`; -1 = none
  int opacity_map = -1;   ///< red from 0, where all light comes through, to 1, where `transparency` counts; -1 = none
  int reflection_map = -1;                           ///< what the surface reflects in place of the scene; -1 = none
  Surroundings surroundings = Surroundings::sphere;  ///< what that picture is
  double relief_depth = 0.05;                        ///< of that bottom below the surface, in widths of the picture
  bool operator==(const Material&) const = default;
};

/// Whether a picture lies on the surface, which then needs texture coordinates.
inline bool needs_uv(const Material& material) {
  return material.texture >= 0 || material.normal_map >= 0 || material.height_map >= 0 || material.specular_map >= 0 ||
         material.ambient_map >= 0 || material.opacity_map >= 0;
}

}  // namespace ps
