// Shadows of the rasterizer against shadow rays: the share of pixels on which they disagree, for each method and scene.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "image/display.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::shadow_methods_test {
namespace {

constexpr int size = 300;

Frame draw(const Scene& scene, const Settings& settings) {
  return render(scene, {scene.camera, size, size}, settings, request_for(Channel::ids | Channel::shadow));
}

int level_difference(const Rgb8& a, const Rgb8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// Of the pixels at which both show the same object, the share (%) that differ by more than 3 levels of 255: less is
/// the difference between exact and tessellated spheres.
double differing_share(const Frame& traced, const Frame& drawn) {
  int shared = 0, differing = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const PixelId a = traced.ids.at(x, y), b = drawn.ids.at(x, y);
      if (a.object < 0 || a.object != b.object) continue;
      ++shared;
      const Rgb8 p = display_pixel(Vec3d(traced.colour.at(x, y)), {}),
                 q = display_pixel(Vec3d(drawn.colour.at(x, y)), {});
      if (level_difference(p, q) > 3) ++differing;
    }
  return shared == 0 ? 0 : 100.0 * differing / shared;
}

/// The most that each way may differ from shadow rays, in % of the pixels.
struct Bounds {
  const char* scene;
  double without, map, map_filtered, depth_fail, depth_pass;
};

class ShadowMethods : public testing::TestWithParam<Bounds> {};

TEST_P(ShadowMethods, DifferFromShadowRaysByAStatedShare) {
  const Bounds& bounds = GetParam();
  const Scene scene = load_scene(bounds.scene);
  Settings settings = settings_for(scene);
  settings.reflection_depth = 0;
  settings.backface_culling = false;
  settings.shading = Shading::phong;
  settings.renderer = Renderer::ray_tracer;
  settings.shadows = Shadows::traced;
  const Frame traced = draw(scene, settings);
  settings.renderer = Renderer::rasterizer;
  settings.shadow_map_size = 1024;
  settings.stencil_bits = 8;
  settings.shadow_bias = 0.01;
  const auto share = [&](Shadows method, int filter) {
    settings.shadows = method;
    settings.shadow_filter = filter;
    settings.shadow_slope_bias = filter == 1 ? 1 : 3;
    return differing_share(traced, draw(scene, settings));
  };
  const double without = share(Shadows::none, 1);
  const double map = share(Shadows::map, 1);
  const double filtered = share(Shadows::map, 3);
  const double fail = share(Shadows::stencil_depth_fail, 1);
  const double pass = share(Shadows::stencil_depth_pass, 1);
  std::printf("%-20s without %.2f  map %.2f  map 3x3 %.2f  depth-fail %.2f  depth-pass %.2f\n", bounds.scene, without,
              map, filtered, fail, pass);
  EXPECT_GT(without, bounds.without) << "there must be shadows to get wrong";
  EXPECT_LT(map, bounds.map);
  EXPECT_LT(filtered, bounds.map_filtered);
  EXPECT_LT(fail, bounds.depth_fail);
  EXPECT_LT(pass, bounds.depth_pass);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, ShadowMethods,
                         testing::Values(Bounds{"cgfs/shadows", 5, 2, 2, 1, 1}, Bounds{"cgfs/shading", 1, 2, 2, 1, 1},
                                         Bounds{"lab/cornell", 1, 2, 2, 1, 1},
                                         Bounds{"lab/inside-shadow", 5, 2, 2, 1, 100},
                                         Bounds{"lab/stacked-shadows", 1, 2, 2, 1, 1},
                                         Bounds{"octree/attenuation", 1, 2, 2, 1, 1}),
                         [](const testing::TestParamInfo<Bounds>& test) {
                           std::string name = test.param.scene;
                           for (char& letter : name)
                             if (letter == '/' || letter == '-') letter = '_';
                           return name;
                         });

}  // namespace
}  // namespace ps::shadow_methods_test
