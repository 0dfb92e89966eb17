#include "student/scene_bytes.h"

#include <map>

#include "scene/canvas_item.h"
#include "student/scene_fields.h"

namespace ps {
namespace {

/// Each model once, then the instances with the indices of theirs.
void put_instances(ByteWriter& to, const BookScene& scene) {
  std::map<const Mesh*, std::uint32_t> index;
  std::vector<const Mesh*> models;
  for (const BookInstance& instance : scene.instances)
    if (index.try_emplace(instance.model, static_cast<std::uint32_t>(models.size())).second)
      models.push_back(instance.model);
  to.each(models, [](ByteWriter& bytes, const Mesh* model) { model_fields(bytes, *model); });
  to.each(scene.instances, [&](ByteWriter& bytes, const BookInstance& instance) {
    bytes.text(instance.name);
    bytes.value(index.at(instance.model));
    bytes.value(*instance.instance);
  });
}

/// Only those that lie on a surface as its colours or its normals; the others are left empty.
void put_textures(ByteWriter& to, const Scene& scene) {
  std::vector<bool> used(scene.textures->size());
  for (const Material& material : *scene.materials)
    for (const int texture : {material.texture, material.normal_map})
      if (texture >= 0) used.at(static_cast<std::size_t>(texture)) = true;
  std::size_t number = 0;
  to.each(*scene.textures, [&](ByteWriter& bytes, const Texture& texture) {
    bytes.text(texture.name);
    const bool kept = used[number++] && texture.texels;
    bytes.value(kept ? texture.texels->width() : 0);
    bytes.value(kept ? texture.texels->height() : 0);
    if (kept) bytes.put_all(texture.texels->pixels().data(), texture.texels->pixels().size());
  });
}

/// Polygons come as the lines and triangles that listings make of them.
void put_canvas_items(ByteWriter& to, const Scene& scene) {
  to.each(lines_and_triangles(*scene.canvas_items), [](ByteWriter& bytes, const CanvasItem& item) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    bytes.value(triangle != nullptr);
    if (triangle)
      bytes.value(*triangle);
    else
      bytes.value(std::get<CanvasLine>(item));
  });
}

}  // namespace

std::string scene_bytes(const BookScene& scene, const ListingTask& task) {
  ByteWriter to;
  to.value(task);
  to.value(scene.settings);
  to.value(scene.camera);
  to.value(scene.width);
  to.value(scene.height);
  to.value(scene.background);
  to.list(scene.lights);
  to.each(scene.spheres, sphere_fields);
  put_instances(to, scene);
  to.each(*scene.scene.materials, material_fields);
  put_textures(to, scene.scene);
  put_canvas_items(to, scene.scene);
  return to.take();
}

}  // namespace ps
