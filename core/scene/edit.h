#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace ps {

/// Something in a scene that can be changed while it is looked at. Paths count from 0 in the scene's order:
///   background
///   camera.position  camera.right  camera.up  camera.forward  camera.rotation
///   camera.viewport_size  camera.projection_plane_d
///   light.N.intensity  light.N.color  light.N.position  light.N.attenuation  light.N.radius (point)
///   light.N.direction (directional)  light.N.specular_color  light.N.ambient_color (both)
///   object.N.center  object.N.radius (spheres) object.N.point  object.N.normal (planes)  object.N.corner
///   object.N.side_a  object.N.side_b (rectangles) object.N.center  object.N.size  object.N.rotation (boxes)
///   object.N.from  object.N.to  object.N.radius (cylinders) object.N.part.K.center ... (part K of a CSG object, in the
///   order of the file) object.N.scale  object.N.rotation  object.N.translation (instances)
///   object.N.color  object.N.texture (those that takes_texture(): a picture file, the name of a texture, or none; the
///   object then has its material for itself), and all that follows (those that has_one_material()) material.N.color
///   material.N.specular (-1 = matte)  material.N.reflective material.N.transparency  material.N.refraction_index
///   material.N.relief_depth (those with a height map)
struct SceneProperty {
  std::string path;
  std::string value;  ///< as a scene file has it: "(2, 1, 0)"; set_property reads it back exactly
};

/// All properties of a scene with their values now.
std::vector<SceneProperty> scene_properties(const Scene& scene);
/// The value of one. Throws InputError for a path that does not exist.
std::string get_property(const Scene& scene, std::string_view path);
/// Changes one. Only the part of the scene that holds it gets a new revision. Throws InputError for a path that does
/// not exist and for a value that a scene file could not have; the scene is then unchanged.
void set_property(Scene& scene, std::string_view path, std::string_view value);

}  // namespace ps
