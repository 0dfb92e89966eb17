#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/check.h"
#include "scene/camera.h"
#include "scene/canvas_item.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/object.h"
#include "scene/part.h"
#include "scene/texture.h"

namespace ps {

/// Geometry in the world: read by accelerators, tessellation and projection, never by shading alone.
struct Geometry {
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<Object> objects;
};

/// A setting that a scene file asks for, unchecked: scene/ does not know the options (see options/scene_settings.h).
struct SceneSetting {
  std::string key, value;
  SourcePlace key_place{}, value_place{};  ///< where they are in their file
  bool operator==(const SceneSetting& other) const { return key == other.key && value == other.value; }
};

/// The parts of a scene on which its picture depends besides view and settings, by their revisions, and its background.
/// Scenes of equal revisions look alike from any camera.
struct SceneRevision {
  std::uint64_t geometry = 0, lights = 0, materials = 0, textures = 0, canvas_items = 0;
  Vec3d background{};
  bool operator==(const SceneRevision&) const = default;
};

/// Everything that is drawn, as an immutable value whose unchanged parts are shared between copies. World coordinates
/// keep their source's own numbers.
struct Scene {
  std::string name;         ///< "cgfs/reflections", or the file's path
  std::string title;        ///< for people; from the file, else the name
  std::string description;  ///< one or two sentences for the scene list; may be empty
  std::string keywords;     ///< other words that people search for, separated by commas; may be empty
  int canvas_width = 600;   ///< the size used when none is asked for
  int canvas_height = 600;
  Camera camera;
  Vec3d background{1, 1, 1};
  Part<Geometry> geometry;
  Part<std::vector<Light>> lights;
  Part<std::vector<Material>> materials;
  Part<std::vector<Texture>> textures;
  Part<std::vector<CanvasItem>> canvas_items;
  /// Option settings that the scene file asks for, as key and value, in the file's order.
  std::vector<SceneSetting> settings;
  /// The pixel that is picked at first, at the canvas size, or (-1, -1): the one that shows what the scene is about.
  Vec2i start_pixel{-1, -1};
  /// The files that it was read from: the scene itself, then those it includes, models, materials and textures.
  std::vector<std::string> files;
  /// Parts that the files ask for and that are missing, in whole sentences: the scene is shown without it.
  std::vector<std::string> warnings;

  SceneRevision revision() const {
    return {geometry.revision(), lights.revision(),       materials.revision(),
            textures.revision(), canvas_items.revision(), background};
  }
};

/// Which features a scene can use at all; options that need an absent feature are greyed, and renderers skip them.
struct SceneTraits {
  bool spheres = false;
  bool triangles = false;
  bool vertex_normals = false;
  bool textures = false;
  bool normal_maps = false;
  bool height_maps = false;
  bool reflective = false;
  bool specular = false;
  bool casting_lights = false;  ///< a point or directional light
  bool solids = false;          ///< planes, rectangles, boxes, cylinders
  bool csg = false;
  bool transparent = false;
  bool attenuated = false;  ///< a point light that grows weaker with distance in a way of its own
  bool point_lights = false;
  bool lamps = false;         ///< a point light with a radius
  bool term_colours = false;  ///< a light whose highlights or ambient light have a colour of their own
  bool stretched = false;     ///< a model or solid that is scaled unequally
  bool patches = false;       ///< curved models that can be cut into triangles anew
  bool light_maps = false;    ///< pictures of highlights or of ambient light
  bool opacity_maps = false;
  bool reflection_maps = false;  ///< on a surface that reflects
  bool mirrors = false;          ///< a surface that reflects the scene, and no picture
  bool canvas_items = false;
  bool canvas_triangles = false;
  bool canvas_intensities = false;  ///< a filled shape on the canvas with an intensity h other than 1
  bool canvas_gradients = false;    ///< a filled shape on the canvas with vertices of different colours
  bool tinted = false;              ///< a surface whose ambient light or highlight has a colour of its own
  bool odd_highlights = false;      ///< a highlight's exponent is not a positive finite number
  bool any_transparency = false;    ///< a transparency above 0, even one that cannot be seen
  bool coloured_lights = false;     ///< a light that is not white
  bool one_sided = false;           ///< triangles that are seen from their front alone
  bool dynamic = false;             ///< objects that are marked so
  bool outgrows_float = false;      ///< its detail is rounded away in float (scene/float_limits.h)
  bool rounds_places = false;       ///< points of its large triangles are, where fragments interpolate them
  bool light_at_surface = false;    ///< a point light lies nearer to a surface than they are exact
  std::size_t sphere_count = 0, light_count = 0;
  std::uint32_t shining_lights = 0;  ///< see shines()
};
/// Whether this light of the scene has a brightness and a colour; of those from the 32nd on, whether any has.
inline bool shines(const SceneTraits& traits, std::size_t light) {
  return light < traits.light_count && (traits.shining_lights >> std::min<std::size_t>(light, 31) & 1u) != 0;
}
SceneTraits scene_traits(const Scene& scene);

/// The material of triangle `triangle` of object `object` (or of the sphere, or of that part of a CSG object).
const Material& material_of(const Scene& scene, int object, int triangle);

}  // namespace ps
