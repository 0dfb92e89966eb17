#include "scene/finish_draft.h"

#include <fmt/format.h>

#include "scene/colour_name.h"
#include "scene/free_names.h"

namespace ps {
namespace {

std::string wanted_name(const Geometry& geometry, const Object& object) {
  if (const auto* instance = std::get_if<Instance>(&object.shape)) return geometry.meshes[instance->mesh]->name;
  if (const auto* solid = std::get_if<Solid>(&object.shape)) return std::string(form_name(solid->form));
  if (const auto* csg = std::get_if<Csg>(&object.shape)) return std::string(operation_name(csg->root.operation));
  return "sphere";
}

/// Unnamed things are called after what they are, "sphere", "sphere 2", ...; unnamed instances after their model.
void name_objects(Geometry& geometry) {
  FreeNames names;
  for (const Object& object : geometry.objects) names.take(object.name);
  for (Object& object : geometry.objects) {
    if (!object.name.empty()) continue;
    object.name = names.claim(wanted_name(geometry, object));
  }
}

/// Unnamed materials are named after the object that has them, those of a model with their colour.
void name_materials(const Geometry& geometry, std::vector<Material>& materials) {
  FreeNames names;
  for (const Material& material : materials) names.take(material.name);
  const auto name = [&](std::uint32_t index, const std::string& wanted) {
    if (materials[index].name.empty()) materials[index].name = names.claim(wanted);
  };
  for (const Object& object : geometry.objects) {
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) name(sphere->material, object.name);
    if (const auto* solid = std::get_if<Solid>(&object.shape)) name(solid->material, object.name);
    if (const auto* csg = std::get_if<Csg>(&object.shape))
      for (const Solid* part : csg_parts(csg->root))
        name(part->material, fmt::format("{} {}", object.name, form_name(part->form)));
    if (const auto* instance = std::get_if<Instance>(&object.shape); instance != nullptr && instance->material)
      name(*instance->material, object.name);
  }
  for (const auto& mesh : geometry.meshes) {
    for (const std::uint32_t slot : mesh->materials) {
      const auto colour = colour_name(materials[slot].colour);
      name(slot, colour && mesh->materials.size() > 1 ? fmt::format("{} {}", mesh->name, *colour) : mesh->name);
    }
  }
}

}  // namespace

Scene finish_draft(SceneDraft draft) {
  Scene scene = std::move(draft.scene);
  if (scene.title.empty()) scene.title = scene.name;
  if (scene.start_pixel.x >= scene.canvas_width || scene.start_pixel.y >= scene.canvas_height)
    throw InputError({scene.name, draft.single_keys["start_pixel"], 1},
                     fmt::format("the pixel ({}, {})", scene.start_pixel.x, scene.start_pixel.y),
                     fmt::format("one inside the canvas of {} x {}", scene.canvas_width, scene.canvas_height));
  name_objects(draft.geometry);
  name_materials(draft.geometry, draft.materials);
  scene.geometry = Part<Geometry>(std::move(draft.geometry));
  scene.lights = Part<std::vector<Light>>(std::move(draft.lights));
  scene.materials = Part<std::vector<Material>>(std::move(draft.materials));
  scene.textures = Part<std::vector<Texture>>(std::move(draft.textures));
  scene.canvas_items = Part<std::vector<CanvasItem>>(std::move(draft.canvas_items));
  return scene;
}

}  // namespace ps
