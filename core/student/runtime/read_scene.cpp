#include "student/runtime/read_scene.h"

#include "student/bytes.h"

namespace ps {
namespace {

constexpr std::size_t longest_name = 1 << 20;

template <class Value>
void get_list(ByteReader& from, std::vector<Value>& values) {
  const auto count = static_cast<std::size_t>(from.get<std::uint64_t>());
  from.require(count, sizeof(Value));
  values.resize(count);
  from.get_all(values.data(), count);
}

BookSphere get_sphere(ByteReader& from) {
  BookSphere sphere;
  sphere.name = from.get_text(longest_name);
  sphere.centre = from.get<Vec3d>();
  sphere.radius = from.get<double>();
  sphere.colour = from.get<Vec3d>();
  sphere.specular = from.get<double>();
  sphere.reflective = from.get<double>();
  return sphere;
}

template <class Value>
void get_optional(ByteReader& from, std::optional<Value>& value) {
  const bool there = from.get<bool>();
  const auto given = from.get<Value>();
  if (there) value = given;
}

Mesh get_model(ByteReader& from) {
  Mesh model;
  model.name = from.get_text(longest_name);
  get_list(from, model.positions);
  get_list(from, model.normals);
  get_list(from, model.uvs);
  get_list(from, model.triangles);
  get_list(from, model.materials);
  return model;
}

void get_instance(ByteReader& from, ReadScene& read) {
  BookInstance instance;
  instance.name = from.get_text(longest_name);
  instance.model = &read.models.at(from.get<std::uint32_t>());
  Instance placed;
  placed.transform = from.get<Transform>();
  get_optional(from, placed.material);
  placed.sides = from.get<Sides>();
  instance.instance = &read.instances.emplace_back(placed);
  read.book->instances.push_back(instance);
}

Material get_material(ByteReader& from) {
  Material material;
  material.colour = from.get<Vec3d>();
  get_optional(from, material.specular);
  material.reflective = from.get<double>();
  get_optional(from, material.specular_colour);
  get_optional(from, material.ambient_colour);
  material.transparency = from.get<double>();
  material.refraction_index = from.get<double>();
  material.texture = from.get<int>();
  return material;
}

Texture get_texture(ByteReader& from) {
  Texture texture;
  texture.name = from.get_text(longest_name);
  const int width = from.get<int>(), height = from.get<int>();
  Image<Vec3f> texels(width, height);
  from.get_all(texels.pixels().data(), texels.pixels().size());
  texture.texels = std::make_shared<const Image<Vec3f>>(std::move(texels));
  return texture;
}

CanvasItem get_canvas_item(ByteReader& from) {
  if (!from.get<bool>()) return from.get<CanvasLine>();
  CanvasTriangle triangle;
  triangle.points = from.get<std::array<Vec2d, 3>>();
  triangle.colours = from.get<std::array<Vec3d, 3>>();
  triangle.h = from.get<std::array<double, 3>>();
  triangle.filled = from.get<bool>();
  triangle.blend = from.get<Blend>();
  get_optional(from, triangle.outline);
  return triangle;
}

/// A list: its length, then its elements, which `get` reads.
template <class Get>
auto get_several(ByteReader& from, Get get) {
  std::vector<decltype(get(from))> all;
  for (auto left = from.get<std::uint64_t>(); left > 0; --left) all.push_back(get(from));
  return all;
}

}  // namespace

std::unique_ptr<ReadScene> read_scene(std::string_view bytes) {
  ByteReader from(bytes);
  auto read = std::make_unique<ReadScene>();
  read->task.picture = from.get<bool>();
  const auto traced = from.get<Vec2i>();
  if (traced.x >= 0) read->task.traced = traced;
  read->settings = from.get<Settings>();
  const auto camera = from.get<Camera>();
  const int width = from.get<int>(), height = from.get<int>();
  const auto background = from.get<Vec3d>();
  std::vector<Light> lights;
  get_list(from, lights);
  read->scene.lights = Part(std::move(lights));
  read->book = std::unique_ptr<BookScene>(
      new BookScene{read->scene, read->settings, camera, width, height, background, {}, {}, *read->scene.lights, {}});
  read->book->spheres = get_several(from, get_sphere);
  for (auto left = from.get<std::uint64_t>(); left > 0; --left) read->models.push_back(get_model(from));
  for (auto left = from.get<std::uint64_t>(); left > 0; --left) get_instance(from, *read);
  read->scene.materials = Part(get_several(from, get_material));
  read->scene.textures = Part(get_several(from, get_texture));
  read->scene.canvas_items = Part(get_several(from, get_canvas_item));
  return read;
}

}  // namespace ps
