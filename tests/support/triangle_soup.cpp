#include "support/triangle_soup.h"

#include <cmath>
#include <memory>

#include "image/display.h"

namespace ps::test {
namespace {

/// Triangles without any order, of sizes from a hundredth of a pixel to the whole picture, with and without normals.
std::shared_ptr<const Mesh> soup(std::mt19937& random, int triangles) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> dice(0, 9);
  auto mesh = std::make_shared<Mesh>();
  const auto direction = [&] { return Vec3d(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < triangles; ++i) {
    const double z = dice(random) == 0 ? 2.0 * unit(random) : 3 + 2 * unit(random);
    const Vec3d centre(unit(random) * z, unit(random) * z, z);
    const double size = std::pow(10.0, -1.7 + 1.7 * unit(random));
    MeshTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.position[k] = static_cast<std::uint32_t>(mesh->positions.size());
      mesh->positions.push_back(centre + size * direction());
      if (dice(random) > 0) {
        triangle.normal[k] = static_cast<std::int32_t>(mesh->normals.size());
        mesh->normals.push_back(direction());
      }
      if (dice(random) > 0) {
        triangle.uv[k] = static_cast<std::int32_t>(mesh->uvs.size());
        mesh->uvs.emplace_back(4 * unit(random), 4 * unit(random));
      }
    }
    if (dice(random) == 0) triangle.position[2] = triangle.position[0];
    triangle.material = static_cast<std::uint32_t>(dice(random) % 3);
    mesh->triangles.push_back(triangle);
  }
  // A strip that crosses the picture at one depth, whose neighbours share their edges exactly.
  for (int i = 0; i < 40; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh->positions.size());
    for (const double y : {-0.4, 0.5}) mesh->positions.emplace_back(-2 + 0.1 * i, y + 0.01 * i, 2.5);
    if (i == 0) continue;
    MeshTriangle& lower = mesh->triangles.emplace_back();
    lower.position = {first - 2, first - 1, first};
    MeshTriangle& upper = mesh->triangles.emplace_back();
    upper.position = {first, first - 1, first + 1};
    lower.material = upper.material = static_cast<std::uint32_t>(i % 3);
  }
  mesh->materials = {0, 1, 2};
  return mesh;
}

}  // namespace

Scene triangle_soup(std::mt19937& random) {
  Scene scene;
  scene.materials.edit([](std::vector<Material>& materials) {
    materials.resize(3);
    materials[0].colour = {0.9, 0.3, 0.2};
    materials[0].specular = 20;
    materials[1].texture = 0;
    materials[2].colour = {0.1, 0.6, 0.9};
    materials[2].texture = 1;
  });
  Image<Vec3f> texels(37, 20);
  std::uniform_real_distribution<float> level(0, 1);
  for (Vec3f& texel : texels.pixels()) texel = {level(random), level(random), level(random)};
  // The same as a picture file holds it, which the fast path keeps in another form.
  Image<Rgb8> levels = display_image(texels);
  levels.pixels()[0] = {0, 0, 0};
  levels.pixels()[1] = {255, 255, 255};
  Texture noise, file;
  noise.texels = std::make_shared<const Image<Vec3f>>(std::move(texels));
  file.texels = std::make_shared<const Image<Vec3f>>(to_unit(levels));
  scene.textures.edit([&](std::vector<Texture>& textures) { textures = {noise, file}; });
  scene.lights.edit([](std::vector<Light>& lights) {
    lights.resize(3);
    lights[0].intensity = 0.2;
    lights[1].kind = LightKind::point;
    lights[1].position = {1, 2, 0};
    lights[2].kind = LightKind::directional;
    lights[2].direction = {-1, 1, -1};
  });
  scene.geometry.edit([&](Geometry& geometry) {
    geometry.meshes = {soup(random, 900), soup(random, 3000)};
    geometry.objects.push_back({"few", Instance{}});
    Instance turned;
    turned.mesh = 1;
    geometry.objects.push_back({"many", turned});
  });
  return scene;
}

}  // namespace ps::test
