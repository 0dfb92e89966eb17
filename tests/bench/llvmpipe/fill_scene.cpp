#include "bench/llvmpipe/fill_scene.h"

#include <cmath>

#include "bench/meshes.h"

namespace ps::bench {
namespace {

/// A smooth pattern, so that the yardstick's coarser filter weights do not show.
Texture fill_texture() {
  constexpr int size = 1024;
  Image<Vec3f> texels(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double a = 0.5 + 0.4 * std::sin(x * 0.11) * std::cos(y * 0.07), b = 0.5 + 0.4 * std::sin((x + y) * 0.03);
      const auto level = [](double value) { return static_cast<float>(std::round(value * 255) / 255); };
      texels.at(x, y) = {level(a), level(b), level(1 - a)};
    }
  return {"pattern", "", std::make_shared<const Image<Vec3f>>(std::move(texels))};
}

}  // namespace

FillScene fill_scene(int width, int height, bool textured) {
  auto mesh = std::make_shared<Mesh>();
  mesh->name = "screen";
  const double x = 1.0 * width / height, repeats_x = 4, repeats_y = repeats_x * height / width;
  mesh->positions = {{-x, 1, 2}, {-x, -1, 2}, {x, -1, 2}, {x, 1, 2}};
  mesh->uvs = {{0, 0}, {0, repeats_y}, {repeats_x, repeats_y}, {repeats_x, 0}};
  for (Vec2d& uv : mesh->uvs) uv += 1.0 / 30 / 1024;  // no pixel's centre falls on the edge between two texels
  mesh->materials = {0};
  MeshTriangle lower, upper;
  // The frame is left-handed (x right, y up, z forward), in which the front turns clockwise.
  lower.position = {0, 2, 1};
  lower.uv = {0, 2, 1};
  upper.position = {0, 3, 2};
  upper.uv = {0, 3, 2};
  mesh->triangles = {lower, upper};
  Scene scene = mesh_scene(mesh);
  scene.materials.edit([&](auto& materials) {
    materials[0].colour = {1, 1, 1};
    materials[0].texture = textured ? 0 : -1;
  });
  scene.textures = Part<std::vector<Texture>>({fill_texture()});
  View view;
  view.width = width;
  view.height = height;
  view.camera.viewport_width = x;
  return {std::move(scene), view};
}

}  // namespace ps::bench
