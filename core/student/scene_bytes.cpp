#include "student/scene_bytes.h"

#include <map>
#include <optional>
#include <type_traits>

#include "scene/canvas_item.h"
#include "student/bytes.h"

namespace ps {
namespace {

static_assert(std::is_trivially_copyable_v<Settings> && std::is_trivially_copyable_v<Camera> &&
              std::is_trivially_copyable_v<Light> && std::is_trivially_copyable_v<MeshTriangle>);

template <class Value>
void put_list(ByteWriter& to, const std::vector<Value>& values) {
  to.put(static_cast<std::uint64_t>(values.size()));
  to.put_all(values.data(), values.size());
}

template <class Value>
void put_optional(ByteWriter& to, const std::optional<Value>& value) {
  to.put(value.has_value());
  to.put(value.value_or(Value{}));
}

void put_spheres(ByteWriter& to, const BookScene& scene) {
  to.put(static_cast<std::uint64_t>(scene.spheres.size()));
  for (const BookSphere& sphere : scene.spheres) {
    to.put_text(sphere.name);
    to.put(sphere.centre);
    to.put(sphere.radius);
    to.put(sphere.colour);
    to.put(sphere.specular);
    to.put(sphere.reflective);
  }
}

/// Each model once, then the instances with the indices of theirs.
void put_instances(ByteWriter& to, const BookScene& scene) {
  std::map<const Mesh*, std::uint32_t> index;
  std::vector<const Mesh*> models;
  for (const BookInstance& instance : scene.instances)
    if (index.try_emplace(instance.model, static_cast<std::uint32_t>(models.size())).second)
      models.push_back(instance.model);
  to.put(static_cast<std::uint64_t>(models.size()));
  for (const Mesh* model : models) {
    to.put_text(model->name);
    put_list(to, model->positions);
    put_list(to, model->normals);
    put_list(to, model->uvs);
    put_list(to, model->triangles);
    put_list(to, model->materials);
  }
  to.put(static_cast<std::uint64_t>(scene.instances.size()));
  for (const BookInstance& instance : scene.instances) {
    to.put_text(instance.name);
    to.put(index.at(instance.model));
    to.put(instance.instance->transform);
    put_optional(to, instance.instance->material);
    to.put(instance.instance->sides);
  }
}

void put_materials(ByteWriter& to, const Scene& scene) {
  to.put(static_cast<std::uint64_t>(scene.materials->size()));
  for (const Material& material : *scene.materials) {
    to.put(material.colour);
    put_optional(to, material.specular);
    to.put(material.reflective);
    put_optional(to, material.specular_colour);
    put_optional(to, material.ambient_colour);
    to.put(material.transparency);
    to.put(material.refraction_index);
    to.put(material.texture);
  }
}

/// Only those that lie on a surface as its colour; the others are left empty.
void put_textures(ByteWriter& to, const Scene& scene) {
  std::vector<bool> used(scene.textures->size());
  for (const Material& material : *scene.materials)
    if (material.texture >= 0) used.at(static_cast<std::size_t>(material.texture)) = true;
  to.put(static_cast<std::uint64_t>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i) {
    const Texture& texture = (*scene.textures)[i];
    to.put_text(texture.name);
    const bool kept = used[i] && texture.texels;
    to.put(kept ? texture.texels->width() : 0);
    to.put(kept ? texture.texels->height() : 0);
    if (kept) to.put_all(texture.texels->pixels().data(), texture.texels->pixels().size());
  }
}

/// Polygons come as the lines and triangles that listings make of them.
void put_canvas_items(ByteWriter& to, const Scene& scene) {
  const std::vector<CanvasItem> items = lines_and_triangles(*scene.canvas_items);
  to.put(static_cast<std::uint64_t>(items.size()));
  for (const CanvasItem& item : items) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    to.put(triangle != nullptr);
    if (!triangle) {
      to.put(std::get<CanvasLine>(item));
      continue;
    }
    to.put(triangle->points);
    to.put(triangle->colours);
    to.put(triangle->h);
    to.put(triangle->filled);
    to.put(triangle->blend);
    put_optional(to, triangle->outline);
  }
}

}  // namespace

std::string scene_bytes(const BookScene& scene, const ListingTask& task) {
  ByteWriter to;
  to.put(task.picture);
  to.put(task.traced.value_or(Vec2i{-1, -1}));
  to.put(scene.settings);
  to.put(scene.camera);
  to.put(scene.width);
  to.put(scene.height);
  to.put(scene.background);
  put_list(to, scene.lights);
  put_spheres(to, scene);
  put_instances(to, scene);
  put_materials(to, scene.scene);
  put_textures(to, scene.scene);
  put_canvas_items(to, scene.scene);
  return to.take();
}

}  // namespace ps
