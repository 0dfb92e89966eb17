#include "scene/contents.h"

#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "base/check.h"
#include "base/overloaded.h"
#include "scene/free_names.h"
#include "scene/scene_draft.h"
#include "scene/scene_tree.h"
#include "scene/scene_value.h"

namespace ps {
namespace {

enum class Deed { add, copy, remove };
enum class Thing { object, light };

/// A path of change_contents().
struct Change {
  Thing thing;
  Deed deed;
};

std::optional<Change> change_of(std::string_view path) {
  for (const auto& [name, thing] :
       {std::pair<std::string_view, Thing>{"object.", Thing::object}, {"light.", Thing::light}}) {
    if (!path.starts_with(name)) continue;
    const std::string_view deed = path.substr(name.size());
    if (deed == "add") return Change{thing, Deed::add};
    if (deed == "copy") return Change{thing, Deed::copy};
    if (deed == "remove") return Change{thing, Deed::remove};
  }
  return {};
}

[[noreturn]] void fail(std::string_view path, std::string_view value, const std::string& expected) {
  throw InputError(fmt::format("{}: found '{}', expected {}", path, value.substr(0, 80), expected));
}

/// One of `count` things, and how far its copy lies from it.
struct Which {
  std::size_t index = 0;
  Vec3d shift{0, 0, 0};
};

Which parse_which(std::string_view path, std::string_view value, std::size_t count, Deed deed) {
  Which which;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), which.index);
  const std::string_view rest = value.substr(static_cast<std::size_t>(end - value.data()));
  constexpr std::string_view plus = " + ";
  const bool shifted = deed == Deed::copy && rest.starts_with(plus);
  if (error != std::errc() || which.index >= count || (!rest.empty() && !shifted))
    fail(path, value, count == 0 ? "something in the scene" : fmt::format("an index from 0 to {}", count - 1));
  if (!shifted) return which;
  const std::string name(path);
  const auto entries = scene_tree(fmt::format("value = {}", rest.substr(plus.size())), name);
  if (entries.size() != 1) fail(path, value, "an index, or an index + (x, y, z)");
  which.shift = SceneValues(name).vec3(entries.front().value);
  return which;
}

void move_form(Form& form, const Vec3d& by) {
  std::visit(Overloaded{[&](Ball& ball) { ball.centre += by; }, [&](Plane& plane) { plane.point += by; },
                        [&](Rectangle& rectangle) { rectangle.corner += by; },
                        [&](Brick& brick) { brick.centre += by; },
                        [&](Cylinder& cylinder) {
                          cylinder.from += by;
                          cylinder.to += by;
                        }},
             form);
}

/// Under a map of its own the body keeps its numbers, and the map moves.
void move_solid(Solid& solid, const Vec3d& by) {
  if (solid.place.is_identity())
    move_form(solid.form, by);
  else
    solid.place.translation += by;
}

void move_object(Object& object, const Vec3d& by) {
  std::visit(Overloaded{[&](Sphere& sphere) { sphere.centre += by; },
                        [&](Instance& instance) { instance.transform.translation += by; },
                        [&](Solid& solid) { move_solid(solid, by); },
                        [&](Csg& csg) {
                          for (Solid* part : csg_parts(csg.root)) move_solid(*part, by);
                        }},
             object.shape);
}

/// Triangles of all models and instances, as scene files count them against their limit.
std::size_t triangles_of(const Geometry& geometry) {
  std::size_t sum = 0;
  for (const auto& mesh : geometry.meshes) sum += mesh->triangles.size();
  for (const Object& object : geometry.objects)
    if (const auto* instance = std::get_if<Instance>(&object.shape))
      sum += geometry.meshes[instance->mesh]->triangles.size();
  return sum;
}

std::string free_name(const Scene& scene, const std::string& wanted) {
  FreeNames names;
  for (const Object& object : scene.geometry->objects) names.take(object.name);
  return names.claim(wanted);
}

void append(Scene& scene, Object object, std::string_view path, std::string_view value) {
  const Geometry& geometry = *scene.geometry;
  if (geometry.objects.size() >= max_scene_objects)
    fail(path, value, fmt::format("at most {} objects in a scene", max_scene_objects));
  if (const auto* instance = std::get_if<Instance>(&object.shape);
      instance && triangles_of(geometry) + geometry.meshes[instance->mesh]->triangles.size() > max_scene_triangles)
    fail(path, value, fmt::format("at most {} triangles in a scene", max_scene_triangles));
  scene.geometry.edit([&](Geometry& changed) { changed.objects.push_back(std::move(object)); });
}

void add_object(Scene& scene, std::string_view path, std::string_view value) {
  const auto material = static_cast<std::uint32_t>(scene.materials->size());
  Object object;
  object.name = free_name(scene, std::string(value));
  if (value == "sphere")
    object.shape = Sphere{{0, 0, 0}, 0.5, material};
  else if (value == "box")
    object.shape = Solid{Brick{}, material};
  else if (value == "cylinder")
    object.shape = Solid{Cylinder{{0, -0.5, 0}, {0, 0.5, 0}, 0.5}, material};
  else
    fail(path, value, "one of sphere, box, cylinder");
  Material plain;
  plain.name = object.name;  // a saved scene then has it inside the object, as in the book
  append(scene, std::move(object), path, value);
  scene.materials.edit([&](std::vector<Material>& materials) { materials.push_back(std::move(plain)); });
}

void change_objects(Scene& scene, Deed deed, std::string_view path, std::string_view value) {
  if (deed == Deed::add) return add_object(scene, path, value);
  const auto& objects = scene.geometry->objects;
  const Which which = parse_which(path, value, objects.size(), deed);
  if (deed == Deed::remove) {
    scene.geometry.edit([&](Geometry& geometry) {
      geometry.objects.erase(geometry.objects.begin() + static_cast<std::ptrdiff_t>(which.index));
    });
    return;
  }
  Object copy = objects[which.index];
  copy.name = free_name(scene, copy.name);
  move_object(copy, which.shift);
  append(scene, std::move(copy), path, value);
}

void change_lights(Scene& scene, Deed deed, std::string_view path, std::string_view value) {
  std::vector<Light> lights = *scene.lights;
  if (deed == Deed::add) {
    Light light{.intensity = 0.5};
    std::string kinds;
    bool known = false;
    for (const LightKind kind : light_kinds) {
      kinds += fmt::format("{}{}", kinds.empty() ? "" : ", ", light_kind_key(kind));
      if (light_kind_key(kind) != value) continue;
      light.kind = kind;
      known = true;
    }
    if (!known) fail(path, value, "one of " + kinds);
    lights.push_back(light);
  } else {
    const Which which = parse_which(path, value, lights.size(), deed);
    const auto at = lights.begin() + static_cast<std::ptrdiff_t>(which.index);
    if (deed == Deed::remove) {
      lights.erase(at);
    } else {
      Light copy = *at;
      if (copy.kind == LightKind::point) copy.position += which.shift;
      lights.push_back(copy);
    }
  }
  if (lights.size() > max_scene_lights) fail(path, value, fmt::format("at most {} lights", max_scene_lights));
  scene.lights.edit([&](std::vector<Light>& changed) { changed = std::move(lights); });
}

}  // namespace

bool changes_contents(std::string_view path) { return change_of(path).has_value(); }

void change_contents(Scene& scene, std::string_view path, std::string_view value) {
  const auto change = change_of(path);
  PS_ASSERT(change, "the path changes what the scene holds");
  switch (change->thing) {
  case Thing::object:
    return change_objects(scene, change->deed, path, value);
  case Thing::light:
    return change_lights(scene, change->deed, path, value);
  }
}

}  // namespace ps
