// Cracks in a picture (stability rows 8 and 14): a surface without holes covers every pixel, even where each pixel's
// ray is aimed at a vertex.
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "render/render.h"
#include "support/closed_sphere.h"
#include "support/trials.h"

namespace cracks_test {
namespace {

using namespace ps;

Scene scene_of(std::shared_ptr<Mesh> mesh) {
  mesh->materials = {0};
  Geometry geometry;
  geometry.meshes = {std::move(mesh)};
  geometry.objects.push_back({"surface", Instance{}});
  Scene scene;
  scene.geometry = Part<Geometry>(std::move(geometry));
  scene.materials = Part<std::vector<Material>>({Material{}});
  scene.camera.viewport_width = scene.camera.viewport_height = 2;
  scene.camera.projection_plane_d = 1;
  return scene;
}

void add(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  MeshTriangle triangle;
  triangle.position = {a, b, c};
  mesh.triangles.push_back(triangle);
}

Scene inside_of_sphere() {
  const test::ClosedSphere sphere = test::closed_sphere(test::side(80), test::side(160), 2, {0, 0, 0});
  auto mesh = std::make_shared<Mesh>();
  for (const Vec3f& vertex : sphere.vertices) mesh->positions.emplace_back(vertex);
  for (const auto& corners : sphere.triangles) add(*mesh, corners[0], corners[1], corners[2]);
  return scene_of(std::move(mesh));
}

/// A rough wall with a vertex on the ray of every pixel of a picture of `size` x `size`, and a margin of one pixel.
Scene wall_of_pixels(int size, unsigned seed) {
  std::mt19937_64 random(seed);
  auto mesh = std::make_shared<Mesh>();
  for (int y = -1; y <= size; ++y)
    for (int x = -1; x <= size; ++x) {
      const double depth = 2 + static_cast<double>(random() >> 11) * 0x1p-53;
      mesh->positions.push_back(Vec3d((x + 0.5) / size * 2 - 1, 1 - (y + 0.5) / size * 2, 1) * depth);
    }
  const auto columns = static_cast<std::uint32_t>(size + 2);
  for (std::uint32_t y = 0; y + 1 < columns; ++y)
    for (std::uint32_t x = 0; x + 1 < columns; ++x) {
      const std::uint32_t a = y * columns + x;
      add(*mesh, a, a + 1, a + columns);
      add(*mesh, a + 1, a + columns + 1, a + columns);
    }
  return scene_of(std::move(mesh));
}

int uncovered(const Scene& scene, int size, const Settings& settings) {
  Prepared prepared;
  Progress progress;
  RenderRequest request;
  request.channels = Channel::ids;
  const Frame frame = render(scene, View{scene.camera, size, size}, settings, request, prepared, progress);
  int count = 0;
  for (const PixelId& id : frame.ids.pixels()) count += id.object < 0 ? 1 : 0;
  return count;
}

constexpr unsigned seed = 8;

TEST(Cracks, AWatertightTestLeavesNone) {
  const Scene sphere = inside_of_sphere();
  const int wall_size = 30 + test::trials(70), even = test::side(128);
  const Scene wall = wall_of_pixels(wall_size, seed);
  for (const Accelerator accelerator : {Accelerator::bvh, Accelerator::octree})
    for (const Simd simd : {Simd::off, Simd::automatic}) {
      Settings settings;
      settings.near = 0;
      settings.accelerator = accelerator;
      settings.simd = simd;
      EXPECT_EQ(uncovered(wall, wall_size, settings), 0) << "seed " << seed;
      for (const int size : {even, even + 1}) EXPECT_EQ(uncovered(sphere, size, settings), 0) << size;
    }
}

TEST(Cracks, MoellerTrumboreSeesThroughTheWall) {
  const Scene wall = wall_of_pixels(100, seed);
  for (const Simd simd : {Simd::off, Simd::automatic}) {
    Settings settings;
    settings.near = 0;
    settings.simd = simd;
    settings.triangle_test = TriangleTest::moeller_trumbore;
    const int cracks = uncovered(wall, 100, settings);
    std::cout << cracks << " of 10000 pixels see through the wall (seed " << seed << ")\n";
    EXPECT_GT(cracks, 100) << "one ray in ten aimed at a vertex slips through";
  }
}

}  // namespace
}  // namespace cracks_test
