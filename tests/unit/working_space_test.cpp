// Where float computes: scenes near the origin stay as they are, those far from it or of extreme sizes look as they do
// in double, and stories tell the world's numbers.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "frame/working_scene.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "render/render.h"
#include "scene/float_limits.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/shown_levels.h"

namespace ps::working_space_test {
namespace {

constexpr int picture_width = 60, picture_height = 45;

std::string at(const Vec3d& origin, double size, double x, double y, double z) {
  return fmt::format("({:.17g},{:.17g},{:.17g})", origin.x + size * x, origin.y + size * y, origin.z + size * z);
}

/// Balls, boxes (one of them cut by a ball), a model placed twice, a floor, and a point light, `size` large around `o`.
Scene scene_at(const Vec3d& o, double size = 1) {
  const auto length = [&](double factor) { return fmt::format("{:.17g}", size * factor); };
  std::string text = fmt::format("projection_plane_d = {} viewport_size = {} x {} background = white ", length(1),
                                 length(1), length(0.75));
  text += "camera { position = " + at(o, size, 0.5, 1, -4) + " } ";
  text += "sphere { center = " + at(o, size, -1, 0, 0) + " radius = " + length(0.6) +
          " color = red specular = 20 reflective = 0.3 } ";
  text += "box { center = " + at(o, size, 0.9, 0.1, 0.3) + " size = (" + length(0.8) + "," + length(1.1) + "," +
          length(0.7) + ") color = green } ";
  text += "model { name = m color = blue vertices { (0,0,0) (1,0,0) (0,1,0) (0,0,-1) } triangles { (0,2,1,blue) "
          "(0,1,3,blue) (0,3,2,blue) (1,2,3,blue) } } ";
  for (const double x : {-0.3, 1.6})
    text += "instance { model = m transform = { scale = " + length(0.5) +
            " translation = " + at(o, size, x, 0.6, -0.4) + " } } ";
  text += "rectangle { corner = " + at(o, size, -6, -0.7, -6) + " side_a = (0,0," + length(12) + ") side_b = (" +
          length(12) + ",0,0) color = (200,200,200) } ";
  text += "light { type = ambient intensity = 0.2 } light { type = point intensity = 0.7 position = " +
          at(o, size, 2, 4, -3) + " } ";
  return parse_scene(text, "far.scene", ".");
}

Image<Rgb8> levels_of(const Scene& scene, const Settings& settings) {
  return test::levels_of(scene, settings, picture_width, picture_height);
}

constexpr std::array far_places{Vec3d{5e5, 120, 5.5e6}, Vec3d{-5.5e6, 5e5, 3e5}, Vec3d{3e7, -3e7, 3e7}};

TEST(WorkingSpace, IsTheWorldForEveryBuiltInSceneButTheFarOne) {
  for (const BuiltinScene& each : builtin_scenes()) {
    const Scene scene = load_scene(each.name);
    EXPECT_EQ(working_space(scene).is_world(), each.name != "lab/far-origin") << each.name;
    const FloatLimits limits = float_limits(scene);
    EXPECT_FALSE(limits.detail || limits.places || limits.light_at_surface) << each.name;
  }
}

TEST(WorkingSpace, HasAnOriginOfFewBitsNearTheScene) {
  for (const Vec3d& place : far_places) {
    const WorkingSpace space = working_space(scene_at(place));
    EXPECT_EQ(space.scale, 1);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(std::abs(space.origin[axis] - place[axis]), 16) << axis;
      EXPECT_EQ(std::fmod(space.origin[axis], 2), 0) << axis;
    }
  }
}

TEST(WorkingSpace, RaysFarFromTheOriginShowWhatDoubleShows) {
  const Option& accelerators = *find_option("accelerator");
  for (const Vec3d& place : far_places) {
    const Scene scene = scene_at(place);
    Settings exact;
    exact.precision = Precision::float64;
    const Image<Rgb8> truth = levels_of(scene, exact);
    for (std::size_t i = 0; i < accelerators.choices.size(); ++i) {
      Settings settings;
      settings.accelerator = static_cast<Accelerator>(i);
      EXPECT_LE(test::differing(levels_of(scene, settings), truth), 4) << place.x << " " << accelerators.choices[i].key;
      settings.camera_relative = false;
      EXPECT_GT(test::differing(levels_of(scene, settings), truth), 200)
          << place.x << " " << accelerators.choices[i].key;
    }
  }
}

TEST(WorkingSpace, PicturesDoNotDependOnTheSizeOfTheScene) {
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    settings.shadows = renderer == Renderer::ray_tracer ? Shadows::traced : Shadows::stencil_depth_fail;
    const Image<Rgb8> wanted = levels_of(scene_at({0, 0, 0}), settings);
    for (const double size : {0.1, 1e-3, 1e-5, 1e-7, 1e-12, 1e-15, 1e-20, 1e-25, 1e-40, 1e-100, 1e10})
      EXPECT_LE(test::differing(levels_of(scene_at({0, 0, 0}, size), settings), wanted), 8) << size;
  }
}

TEST(WorkingSpace, StaysWhereItIsWhileTheCameraMoves) {
  Scene scene = scene_at(far_places[0]);
  Prepared prepared;
  const Settings settings;
  const View here{scene.camera, 8, 8};
  View there = here;
  there.camera.position.x += 3;
  const WorkingScene first(scene, here, settings, prepared), second(scene, there, settings, prepared);
  EXPECT_EQ(first.space, second.space);
  EXPECT_EQ(first.scene().geometry.revision(), second.scene().geometry.revision());
  EXPECT_NE(first.scene().geometry.revision(), scene.geometry.revision());
}

TEST(WorkingSpace, WhatFloatCannotDoNeedsDouble) {
  // A ball of radius 1 far from the middle of a floor that reaches from one end of the world to the other.
  const Scene scene = parse_scene("camera { position = (5e6,2,-5) } sphere { center = (5e6,1,0) radius = 1 } "
                                  "box { center = (0,-1,0) size = (2e7,1,2e7) } light { type = ambient intensity = 1 }",
                                  "large.scene", ".");
  EXPECT_TRUE(working_space(scene).is_world());
  ASSERT_TRUE(scene_traits(scene).outgrows_float);
  Settings settings;
  const std::vector<LeftOut> said = left_out(scene_traits(scene), settings);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].sentence.find("needs precision = double"), std::string::npos);
  EXPECT_EQ(said[0].remedies.at(0).setting, "precision=double");
  settings.precision = Precision::float64;
  EXPECT_TRUE(left_out(scene_traits(scene), settings).empty());
  for (const Vec3d& place : far_places) EXPECT_FALSE(float_limits(scene_at(place)).detail);
}

/// The pixels below the horizon of a ground 1 below the eye that reaches as far as that.
int ground_pixels(double reach, const Settings& settings) {
  const std::string r = fmt::format("{}", reach);
  const Scene scene = parse_scene(
      fmt::format(
          "canvas_size = 65 x 65 background = black settings {{ near = 0.0001 }} model {{ name = g color = white "
          "vertices {{ (-{0},-1,-{0}) ({0},-1,-{0}) ({0},-1,{0}) (-{0},-1,{0}) }} triangles {{ (0,2,1,white) "
          "(0,3,2,white) }} }} instance {{ model = g }} light {{ type = ambient intensity = 1 }}",
          r),
      "ground.scene", ".");
  Settings own = settings_for(scene);
  own.renderer = settings.renderer;
  own.accelerator = settings.accelerator;
  own.triangle_test = settings.triangle_test;
  const Frame frame = render(scene, {scene.camera, 65, 65}, own);
  return static_cast<int>(std::count_if(frame.colour.pixels().begin(), frame.colour.pixels().end(),
                                        [](const Vec3f& colour) { return colour.x > 0.5f; }));
}

TEST(WorkingSpace, GroundsReachToTheHorizon) {
  const Option& accelerators = *find_option("accelerator");
  for (const double reach : {1e4, 1e6, 1e8, 1e10, 1e12}) {
    for (const TriangleTest test : {TriangleTest::watertight, TriangleTest::moeller_trumbore})
      for (std::size_t i = 0; i < accelerators.choices.size(); ++i) {
        Settings settings;
        settings.triangle_test = test;
        settings.accelerator = static_cast<Accelerator>(i);
        EXPECT_EQ(ground_pixels(reach, settings), 32 * 65) << reach << " " << accelerators.choices[i].key;
      }
    Settings settings{.renderer = Renderer::rasterizer};
    EXPECT_NEAR(ground_pixels(reach, settings), 32 * 65, 65) << reach;
  }
}

/// A white quad before the eye, under ambient light and one more.
Scene lit_quad(const std::string& more) {
  return parse_scene(
      "camera { position = (0,0,3) right = (1,0,0) up = (0,1,0) forward = (0,0,-1) } model { name = q color = white "
      "vertices { (-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0) } triangles { (0,1,2,white) (0,2,3,white) } } "
      "instance { model = q } light { type = ambient intensity = 0.2 } " +
          more,
      "quad.scene", ".");
}

TEST(ExtremeNumbers, ALightRightBeforeASurfaceLightsIt) {
  // 0.2 + 0.8, since the light stands upright on the surface.
  for (const char* distance : {"1", "1e-12", "1e-20", "1e-25", "1e-36"})
    for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer})
      for (const Simd simd : {Simd::automatic, Simd::off})
        for (const Highlight highlight : {Highlight::phong, Highlight::blinn_phong}) {
          const Scene scene =
              lit_quad(fmt::format("light {{ type = point intensity = 0.8 position = (0,0,{}) }}", distance));
          Settings settings{.renderer = renderer};
          settings.simd = simd;
          settings.highlight = highlight;
          settings.shadows = renderer == Renderer::ray_tracer ? Shadows::traced : Shadows::none;
          const Frame frame = render(scene, {scene.camera, 33, 33}, settings);
          EXPECT_NEAR(frame.colour.at(16, 16).x, 1, 1e-5) << distance << " " << static_cast<int>(renderer);
        }
}

TEST(ExtremeNumbers, ASliverBesideAQuadLeavesNoTraceAndNoHole) {
  const std::string sun = "light { type = directional intensity = 0.7 direction = (1,1.5,2) } ";
  for (const Accelerator accelerator :
       {Accelerator::bvh, Accelerator::octree, Accelerator::none, Accelerator::two_level})
    for (const Simd simd : {Simd::automatic, Simd::sse4, Simd::avx2, Simd::off}) {
      Settings settings;
      settings.accelerator = accelerator;
      settings.simd = simd;
      const auto picture = [&](const Scene& scene) { return render(scene, {scene.camera, 65, 65}, settings).colour; };
      const Image<Vec3f> wanted = picture(lit_quad(sun));
      for (const char* size : {"1e-10", "1e-13", "1e-16", "1e-19", "1e-25", "1e-36"}) {
        const Scene scene = lit_quad(
            sun +
            fmt::format("model {{ name = s color = white vertices {{ (-{0},-{0},{0}) ({0},-{0},{0}) (0,{0},{0}) }} "
                        "triangles {{ (0,1,2,white) }} }} instance {{ model = s }}",
                        size));
        const Image<Vec3f> found = picture(scene);
        EXPECT_TRUE(std::equal(found.pixels().begin(), found.pixels().end(), wanted.pixels().begin()))
            << size << " " << static_cast<int>(accelerator);
      }
    }
}

}  // namespace
}  // namespace ps::working_space_test
