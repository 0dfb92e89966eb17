#include "render/story/names.h"

#include <fmt/format.h>

#include "render/story/reason_text.h"

namespace ps {
namespace {

/// The object's name without its number: "sphere", or the name of its model.
std::string kind_of(const Geometry& geometry, const Object& object) {
  if (std::holds_alternative<Sphere>(object.shape)) return "sphere";
  if (const auto* solid = std::get_if<Solid>(&object.shape)) return std::string(form_name(solid->form));
  if (const auto* csg = std::get_if<Csg>(&object.shape)) return std::string(operation_name(csg->root.operation));
  const std::string& name = geometry.meshes.at(std::get<Instance>(object.shape).mesh)->name;
  return name.empty() ? "model" : name;
}

std::string material_suffix(const Scene& scene, const Object& object) {
  const auto* sphere = std::get_if<Sphere>(&object.shape);
  if (!sphere || sphere->material >= scene.materials->size()) return {};
  const std::string& name = (*scene.materials)[sphere->material].name;
  return name.empty() ? "" : fmt::format(" ({})", name);
}

/// The name of the model's part that a triangle belongs to, as its file has it: that of the object, else of the group.
/// Empty where it says no more than the model's own name.
std::string part_suffix(const Mesh& mesh, std::size_t triangle, const std::string& model) {
  const std::string& object = mesh.origins.object_of(triangle);
  const std::string& part = object.empty() || object == mesh.name ? mesh.origins.group_of(triangle) : object;
  return part.empty() || part == mesh.name || part == model ? "" : fmt::format(" ({})", part);
}

}  // namespace

std::string object_name(const Scene& scene, int object) {
  const auto& objects = scene.geometry->objects;
  if (object < 0) return "nothing";
  if (static_cast<std::size_t>(object) >= objects.size()) return fmt::format("object {}", object);
  const Object& thing = objects[static_cast<std::size_t>(object)];
  if (!thing.name.empty()) return thing.name;
  const std::string kind = kind_of(*scene.geometry, thing);
  int number = -1;
  for (int i = 0; i <= object; ++i)
    if (kind_of(*scene.geometry, objects[static_cast<std::size_t>(i)]) == kind) ++number;
  return fmt::format("{} {}{}", kind, number, material_suffix(scene, thing));
}

std::string primitive_name(const Scene& scene, const PixelId& id) {
  const auto& objects = scene.geometry->objects;
  std::string name = object_name(scene, id.object);
  if (id.object < 0 || static_cast<std::size_t>(id.object) >= objects.size()) return name;
  const auto& shape = objects[static_cast<std::size_t>(id.object)].shape;
  if (const auto* csg = std::get_if<Csg>(&shape)) {
    const auto parts = csg_parts(csg->root);
    if (id.triangle < 0 || static_cast<std::size_t>(id.triangle) >= parts.size()) return name;
    return fmt::format("part {} ({}) of {}", id.triangle, form_name(parts[static_cast<std::size_t>(id.triangle)]->form),
                       name);
  }
  const auto* instance = std::get_if<Instance>(&shape);
  if (id.triangle < 0 || !instance) return name;
  const Mesh& mesh = *scene.geometry->meshes.at(instance->mesh);
  return fmt::format("triangle {} of {}{}", id.triangle, name,
                     part_suffix(mesh, static_cast<std::size_t>(id.triangle), name));
}

std::string line_name(const Scene& scene, const LineEvent& line) {
  if (line.id.object < 0) return "a line";
  return fmt::format("{} of {}", line.from == line.to ? "a vertex" : "an edge", primitive_name(scene, line.id));
}

std::string light_name(const Scene& scene, int light) {
  if (light < 0 || static_cast<std::size_t>(light) >= scene.lights->size()) return fmt::format("light {}", light);
  const LightKind kind = (*scene.lights)[static_cast<std::size_t>(light)].kind;
  return fmt::format("light {} ({})", light, light_kind_key(kind));
}

}  // namespace ps
