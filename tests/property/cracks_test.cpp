// Cracks in a picture (stability rows 8 and 14): a closed sphere of triangles seen from inside covers every pixel. With
// an odd number of columns and rows the rays of a camera along an axis run exactly through edges and vertices.
#include <gtest/gtest.h>

#include <iostream>

#include "render/render.h"
#include "support/closed_sphere.h"

namespace {

using namespace ps;

Scene inside_of_sphere() {
  const test::ClosedSphere sphere = test::closed_sphere(160, 320, 2, {0, 0, 0});
  auto mesh = std::make_shared<Mesh>();
  mesh->materials = {0};
  for (const Vec3f& vertex : sphere.vertices) mesh->positions.emplace_back(vertex);
  for (const auto& corners : sphere.triangles) {
    MeshTriangle triangle;
    triangle.position = corners;
    mesh->triangles.push_back(triangle);
  }
  Geometry geometry;
  geometry.meshes = {mesh};
  geometry.objects.push_back({"sphere", Instance{}});
  Scene scene;
  scene.geometry = Part<Geometry>(std::move(geometry));
  scene.materials = Part<std::vector<Material>>({Material{}});
  scene.camera.viewport_width = scene.camera.viewport_height = 2;
  return scene;
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

TEST(Cracks, AWatertightTestLeavesNoneAtAnySize) {
  const Scene scene = inside_of_sphere();
  for (const Accelerator accelerator : {Accelerator::bvh, Accelerator::octree})
    for (const Simd simd : {Simd::off, Simd::automatic})
      for (const int size : {512, 513}) {
        Settings settings;
        settings.near = 0;
        settings.accelerator = accelerator;
        settings.simd = simd;
        EXPECT_EQ(uncovered(scene, size, settings), 0) << size;
        settings.triangle_test = TriangleTest::moeller_trumbore;
        const int cracks = uncovered(scene, size, settings);
        std::cout << size << " x " << size << " with Moeller-Trumbore: " << cracks
                  << " pixels see through the sphere\n";
        // Elsewhere, at 2049 x 2049: 426 pixels; at 2048 x 2048: 4. Cracks lie along the middle row and column.
        if (size == 513) {
          EXPECT_GT(cracks, 20);
        } else {
          EXPECT_LT(cracks, 20);
        }
      }
}

}  // namespace
