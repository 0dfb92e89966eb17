#include "student/runtime/read_scene.h"

#include "student/scene_fields.h"

namespace ps {
namespace {

void get_instances(ByteReader& from, ReadScene& read) {
  from.each(read.models, model_fields);
  from.each(read.book->instances, [&](ByteReader& bytes, BookInstance& instance) {
    bytes.text(instance.name);
    instance.model = &read.models.at(bytes.get<std::uint32_t>());
    instance.instance = &read.instances.emplace_back(bytes.get<Instance>());
  });
}

void get_texture(ByteReader& from, Texture& texture) {
  from.text(texture.name);
  const int width = from.get<int>(), height = from.get<int>();
  Image<Vec3f> texels(width, height);
  from.get_all(texels.pixels().data(), texels.pixels().size());
  texture.texels = std::make_shared<const Image<Vec3f>>(std::move(texels));
}

void get_canvas_item(ByteReader& from, CanvasItem& item) {
  if (from.get<bool>())
    item = from.get<CanvasTriangle>();
  else
    item = from.get<CanvasLine>();
}

/// A part of the scene: a list whose elements `fields` reads.
template <class One, class Fields>
Part<std::vector<One>> part_of(ByteReader& from, Fields fields) {
  std::vector<One> all;
  from.each(all, fields);
  return Part(std::move(all));
}

}  // namespace

std::unique_ptr<ReadScene> read_scene(std::string_view bytes) {
  ByteReader from(bytes);
  auto read = std::make_unique<ReadScene>();
  from.value(read->task);
  from.value(read->settings);
  const auto camera = from.get<Camera>();
  const int width = from.get<int>(), height = from.get<int>();
  const auto background = from.get<Vec3d>();
  std::vector<Light> lights;
  from.list(lights);
  read->scene.lights = Part(std::move(lights));
  read->book = std::unique_ptr<BookScene>(
      new BookScene{read->scene, read->settings, camera, width, height, background, {}, {}, *read->scene.lights, {}});
  from.each(read->book->spheres, sphere_fields);
  get_instances(from, *read);
  read->scene.materials = part_of<Material>(from, material_fields);
  read->scene.textures = part_of<Texture>(from, get_texture);
  read->scene.canvas_items = part_of<CanvasItem>(from, get_canvas_item);
  return read;
}

}  // namespace ps
