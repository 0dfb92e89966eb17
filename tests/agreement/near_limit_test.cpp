// What lies right on the near or far limit is seen, by rays as by the rasterizer: the book's interval of t is closed.
#include <gtest/gtest.h>

#include "scene/scene_file.h"
#include "support/all_accelerators.h"
#include "support/render_once.h"

namespace ps::near_limit_test {
namespace {

std::string wall_at(double z, bool triangles) {
  const std::string d = std::to_string(z);
  if (!triangles) return "rectangle { corner=(-9,-9," + d + ") side_a=(18,0,0) side_b=(0,18,0) color=white }";
  return "model { name=m color=white vertices { 0=(-9,-9," + d + ") 1=(9,-9," + d + ") 2=(0,20," + d +
         ") } triangles { 0 = 0,2,1 } } instance { model=m }";
}

/// How many of the picture's 300 pixels show the wall.
int seen_pixels(const std::string& scene_text, const Settings& settings) {
  const Scene scene = parse_scene("background = black " + scene_text, "wall.scene", ".");
  const Frame frame = render(scene, {scene.camera, 20, 15}, settings, request_for(Channel::ids));
  int count = 0;
  for (const PixelId& id : frame.ids.pixels()) count += id.object == 0 ? 1 : 0;
  return count;
}

void expect_closed_limits(const Settings& settings, const std::string& what) {
  for (const bool triangles : {false, true})
    for (const double near : {1.0, 0.7}) {
      Settings limited = settings;
      limited.near = near;
      EXPECT_EQ(seen_pixels(wall_at(near, triangles), limited), 300) << what << ", triangles " << triangles;
      EXPECT_EQ(seen_pixels(wall_at(near - 0.001, triangles), limited), 0) << what << ", triangles " << triangles;
      limited.far = 3;
      EXPECT_EQ(seen_pixels(wall_at(3, triangles), limited), 300) << what << ", triangles " << triangles;
      EXPECT_EQ(seen_pixels(wall_at(3.001, triangles), limited), 0) << what << ", triangles " << triangles;
    }
}

TEST(NearLimit, IsClosedForRays) {
  for (const Accelerator accelerator : test::all_accelerators())
    for (const Simd simd : {Simd::automatic, Simd::off}) {
      Settings settings;
      settings.accelerator = accelerator;
      settings.simd = simd;
      expect_closed_limits(settings, "accelerator " + std::to_string(static_cast<int>(accelerator)));
    }
  for (const TriangleTest test : {TriangleTest::watertight, TriangleTest::moeller_trumbore, TriangleTest::barycentric,
                                  TriangleTest::cross_products}) {
    Settings settings;
    settings.triangle_test = test;
    expect_closed_limits(settings, "triangle test " + std::to_string(static_cast<int>(test)));
    settings.precision = Precision::float64;
    expect_closed_limits(settings, "in double");
  }
  Settings settings;
  settings.samples_per_pixel = 4;
  expect_closed_limits(settings, "four samples");
}

TEST(NearLimit, IsClosedForTheRasterizer) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Settings settings{.renderer = Renderer::rasterizer};
    settings.backface_culling = false;
    settings.precision = precision;
    expect_closed_limits(settings, "rasterizer");
  }
}

// A sphere whose nearest point lies on the limit, by the packets that know spheres alone: one pixel, in the middle.
TEST(NearLimit, IsClosedForSpheres) {
  for (const Simd simd : {Simd::automatic, Simd::off})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Settings settings;
      settings.simd = simd;
      settings.precision = precision;
      settings.far = 1;
      const Scene scene = parse_scene("sphere { center=(0,0,2) radius=1 }", "sphere.scene", ".");
      const Frame frame = render(scene, {scene.camera, 5, 5}, settings, request_for(Channel::ids));
      for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x) EXPECT_EQ(frame.ids.at(x, y).object, x == 2 && y == 2 ? 0 : -1);
    }
}

}  // namespace
}  // namespace ps::near_limit_test
