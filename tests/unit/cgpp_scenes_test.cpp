// The scenes of CGPP ch. 15: their numbers, one pixel worked out by hand, and acne where the book says that it appears.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <iostream>
#include <numbers>

#include "options/scene_settings.h"
#include "raytrace/clear/tracer.h"
#include "raytrace/renderer.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/trials.h"

namespace ps::cgpp_scenes_test {
namespace {

Frame traced(const Scene& scene, const Settings& settings, Channel channels = Channel::none) {
  Prepared prepared;
  Progress progress;
  const View view{scene.camera, test::side(scene.canvas_width), test::side(scene.canvas_height)};
  return render_traced(scene, view, settings, request_for(channels), prepared, progress);
}

TEST(Cgpp, OnePixelOfTheTriangleByHand) {
  const Scene scene = load_scene("cgpp/triangle");
  const Settings settings = settings_for(scene);
  EXPECT_EQ(settings.exposure, 15);
  EXPECT_EQ(settings.gamma, 2.2);
  const int width = test::side(800), height = test::side(500), x = test::side(390), y = test::side(250);
  // Listing 15.14 with 90 degrees between the centres of the first and the last pixel of a row.
  const double s = 2.0 / (width - 1), sy = 1.25 / (height - 1);
  const Vec3d direction{(x + 0.5 - width / 2.0) * s, (height / 2.0 - y - 0.5) * sy, -1};
  const Vec3d point = direction * 2.0;  // the triangle lies in z = -2
  const Vec3d a{0, 1, -2}, b{-1.9, -1, -2}, c{1.6, -0.5, -2};
  const auto area = [](const Vec3d& p, const Vec3d& q, const Vec3d& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  const double whole = area(a, b, c);
  const Vec3d w{area(point, b, c) / whole, area(a, point, c) / whole, area(a, b, point) / whole};
  const Vec3d n = glm::normalize(glm::normalize(Vec3d{0, 0.6, 1}) * w.x + glm::normalize(Vec3d{-0.4, -0.4, 1}) * w.y +
                                 glm::normalize(Vec3d{0.4, -0.4, 1}) * w.z);
  const Vec3d offset = Vec3d{1, 3, 1} - point;
  const double distance = glm::length(offset);
  const Vec3d w_i = offset / distance, w_o = -glm::normalize(point), w_h = glm::normalize(w_i + w_o);
  const double arriving = 10 / (4 * std::numbers::pi * distance * distance) * std::max(0.0, dot(w_i, n));
  const double gloss = 0.2 * 108 * std::pow(std::max(0.0, dot(w_h, n)), 100) / 8;
  const Vec3d expected = (Vec3d{0, 0.8, 0} + gloss) * (arriving / std::numbers::pi);
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Settings with = settings;
    with.precision = precision;
    const Vec3f got = traced(scene, with).colour.at(x, y);
    EXPECT_LT(glm::length(Vec3d(got) - expected), 2e-6 * glm::length(expected) + 1e-7);
  }
}

/// Pixels of the visible green triangle whose light is blocked.
int shadowed_green(const Scene& scene, const Settings& settings) {
  const Frame frame = traced(scene, settings, Channel::ids | Channel::shadow);
  int count = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x)
      if (frame.ids.at(x, y).object == 0 && frame.shadow.at(x, y) != 0) ++count;
  return count;
}

TEST(Cgpp, GroundHasAShadowAndAcneOnlyWithATinyBump) {
  const Scene scene = load_scene("cgpp/ground");
  Settings settings = settings_for(scene);
  const Frame frame = traced(scene, settings, Channel::ids | Channel::shadow);
  int shadow = 0, lit = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x)
      if (frame.ids.at(x, y).object >= 2) (frame.shadow.at(x, y) != 0 ? shadow : lit) += 1;
  EXPECT_GT(shadow, test::area(1000));
  EXPECT_GT(lit, test::area(10000));
  EXPECT_EQ(shadowed_green(scene, settings), 0);
  settings.shadow_epsilon = 1e-9;
  const int acne = shadowed_green(scene, settings);
  std::cout << acne << " pixels of acne with a bump of 1e-9\n";
  EXPECT_GT(acne, test::area(100));
  settings.self_hit = SelfHit::offset;
  EXPECT_EQ(shadowed_green(scene, settings), 0);
}

// "Without the second side, the green triangle would cast no shadow": triangles have a front only.
TEST(Cgpp, TheFrontAloneCastsNoShadowFromBehind) {
  Scene scene = load_scene("cgpp/ground");
  scene.geometry.edit([](Geometry& geometry) { geometry.objects.erase(geometry.objects.begin() + 1); });
  const Frame frame = traced(scene, settings_for(scene), Channel::ids | Channel::shadow);
  int ground = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x)
      if (frame.ids.at(x, y).object >= 1) {
        ++ground;
        ASSERT_EQ(frame.shadow.at(x, y), 0u) << x << ", " << y;
      }
  EXPECT_GT(ground, test::area(11000)) << "lit and shadowed ground of the test before";
}

// CGPP 15.7's indexed meshes are the same triangles, and light adds up: 31 is 3.1 times 10.
TEST(Cgpp, TheIndexedSceneIsTheGroundUnderALightOfPower31) {
  const Scene indexed = load_scene("cgpp/ground-by-hardware"), plain = load_scene("cgpp/ground");
  EXPECT_EQ(indexed.lights->at(0).intensity, 31);
  EXPECT_EQ(settings_for(indexed).renderer, Renderer::rasterizer);
  Settings by_rays = settings_for(indexed);
  by_rays.shadows = Shadows::traced;  // its own are those of a depth map
  const Frame bright = traced(indexed, by_rays, Channel::ids);
  const Frame dim = traced(plain, settings_for(plain), Channel::ids);
  int green = 0;
  for (int y = 0; y < dim.height(); ++y)
    for (int x = 0; x < dim.width(); ++x) {
      const int object = dim.ids.at(x, y).object;
      ASSERT_EQ(bright.ids.at(x, y).object, object < 0 ? -1 : object / 2) << x << ", " << y;
      const Vec3f expected = dim.colour.at(x, y) * (object < 0 ? 1.0f : 3.1f);
      ASSERT_LT(glm::length(bright.colour.at(x, y) - expected), 2e-5f * glm::length(expected) + 1e-7f)
          << x << ", " << y;
      green += object == 0;
    }
  EXPECT_GT(green, test::area(10000));
}

TEST(Cgpp, FourTriangleTestsSeeTheSameTeapot) {
  const Scene scene = load_scene("cgpp/teapot");
  Settings settings = settings_for(scene);
  settings.precision = Precision::float64;
  const Frame reference = traced(scene, settings, Channel::ids);
  int covered = 0;
  for (const TriangleTest test :
       {TriangleTest::moeller_trumbore, TriangleTest::barycentric, TriangleTest::cross_products}) {
    settings.triangle_test = test;
    const Frame frame = traced(scene, settings, Channel::ids | Channel::depth);
    int differing = 0;
    covered = 0;
    for (int y = 0; y < frame.height(); ++y)
      for (int x = 0; x < frame.width(); ++x) {
        covered += frame.ids.at(x, y).object == 0 ? 1 : 0;
        differing += frame.ids.at(x, y) != reference.ids.at(x, y) ? 1 : 0;
      }
    EXPECT_LE(differing, 3) << static_cast<int>(test);
  }
  EXPECT_GT(covered, test::area(30000));
}

}  // namespace
}  // namespace ps::cgpp_scenes_test
