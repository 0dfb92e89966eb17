#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/check.h"
#include "image/read_limit.h"
#include "scene/scene.h"
#include "scene/scene_fields.h"

namespace ps {

/// A scene while its file is being read.
struct SceneDraft {
  Scene scene;  ///< its parts are filled by finish_draft
  Geometry geometry;
  std::vector<Light> lights;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<CanvasItem> canvas_items;
  std::map<std::string, std::uint32_t> mesh_index;      ///< by the model's name
  std::map<std::string, std::uint32_t> material_index;  ///< named materials only
  std::map<std::string, int> texture_index;
  std::map<std::string, int> object_lines;  ///< given names and the line in which each is
  std::map<std::string, int> single_keys;   ///< top-level keys that may be given once, and their lines
  PartPlace group;                          ///< of the groups around the block being read
  int group_depth = 0;
  std::vector<std::filesystem::path> including;  ///< the chain of files being read, outermost first
  std::size_t triangles = 0;                     ///< of models and of instances
  std::size_t texels = 0;                        ///< of all textures
  std::vector<InputError> errors;                ///< of entries read so far
  std::vector<std::string> lost_names;           ///< that these would have given, as messages show them
};

/// Where relative names in the file being read begin.
struct SceneSource {
  SceneValues values;
  std::filesystem::path folder;
};

/// Each reads one block or assignment into the draft. Throws InputError.
void read_sphere(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_solid(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_csg(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_instance(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
/// A group of instances, bodies, operations of CSG and groups with a transform of its own: a hierarchical model (CGFS
/// ch. 10; LAB 7). It leaves only what it holds behind, each with the product of the transforms around it.
void read_group(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_model(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_material(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_texture(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_light(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_camera(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_settings(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_line(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
/// Vertices with three coordinates make a triangle in space, with two one on the canvas.
void read_any_triangle(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
/// Vertices with three coordinates make a convex polygon in space, with two one on the canvas (LAB 4).
void read_any_polygon(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
void read_canvas_polygon(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);
/// A list of 3 to 1000 vertices; throws InputError for another.
void require_polygon_vertices(const SceneSource& source, const SceneTerm& vertices);
/// Do the block's `vertices` have three coordinates?
bool has_vertices_in_space(const SceneEntry& entry);
/// A model of its own with one instance, from `name`, `sides` and the keys of objects: no other code has to know single
/// triangles and polygons. `kind` is its name where the block gives none.
void add_single_model(const SceneSource& source, const SceneFields& fields, std::string_view kind, Mesh mesh,
                      SceneDraft& draft);
void read_canvas_triangle(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft);

/// The `position` and `transform` of a block within CSG.
PartPlace read_part_place(const SceneSource& source, const SceneFields& fields);

/// Factors of nested maps multiply, so even numbers that are allowed one by one may end beyond all bounds. Throws
/// InputError for a place that cannot be inverted in numbers of a reasonable size.
void require_invertible(const SceneSource& source, const SceneEntry& entry, const PartPlace& place);

/// Adds an object with the name that its block gives, if any, and the mark `dynamic = on`.
void add_object(const SceneSource& source, const SceneFields& fields, Object object, SceneDraft& draft);
/// `sides = two` or `front`.
Sides read_sides(const SceneValues& values, const SceneTerm& term);
/// Are the sides of a rectangle perpendicular?
bool has_right_angle(const Rectangle& rectangle);
/// Lengths of the edges of a box: one number for all or three, above 0.
Vec3d read_brick_size(const SceneValues& values, const SceneTerm& term);
/// Constant, linear and quadratic factor of a light, not all 0.
Vec3d read_attenuation(const SceneValues& values, const SceneTerm& term);

/// The keys that describe a surface, in every block that has one.
const std::vector<std::string_view>& surface_keys();
bool has_surface(const SceneFields& fields);
/// `base` with the surface keys of a block written over it.
Material read_surface(const SceneSource& source, const SceneFields& fields, Material base, const SceneDraft& draft);
/// The index of the material that `material = NAME` names.
std::uint32_t find_material(const SceneSource& source, const SceneTerm& name, const SceneDraft& draft);
/// The material of a block: the one it names, or a new one from its surface keys over `base`.
std::uint32_t material_for(const SceneSource& source, const SceneFields& fields, const Material& base,
                           SceneDraft& draft);

/// Largest number of spheres and instances, of lights, and of other things in one scene.
inline constexpr std::size_t max_scene_objects = 100'000;
inline constexpr std::size_t max_scene_lights = 1'000;
/// A short scene file can ask for any number of large things: this many triangles (each model and each instance of it)
/// are the most, about 4 GiB, and as many texels as one picture may have.
inline constexpr std::size_t max_scene_triangles = 16'000'000;
inline constexpr std::size_t max_scene_texels = max_read_pixels;
/// Adds to the draft's sum, which must not pass the limit. Throws InputError at the entry.
void charge_triangles(const SceneSource& source, const SceneEntry& entry, std::size_t count, SceneDraft& draft);
void charge_texels(const SceneSource& source, const SceneEntry& entry, std::size_t count, SceneDraft& draft);

}  // namespace ps
