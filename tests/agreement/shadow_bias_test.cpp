// The default bias of shadow maps: no surface shadows itself, and shadows stay where shadow rays put them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "options/scene_settings.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::shadow_bias_test {
namespace {

Frame shadow_picture(const Scene& scene, const Settings& settings) {
  return render(scene, {scene.camera, 120, 80}, settings, request_for(Channel::ids | Channel::shadow));
}

Settings with_maps(int size, int filter) {
  Settings settings{.renderer = Renderer::rasterizer};
  settings.shadows = Shadows::map;
  settings.shadow_map_size = size;
  settings.shadow_filter = filter;
  return settings;
}

/// Pixels of a surface for which a light counts as hidden.
int dark_pixels(const Frame& frame) {
  int count = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x)
      count += frame.ids.at(x, y).object >= 0 && frame.shadow.at(x, y) != 0 ? 1 : 0;
  return count;
}

// One flat surface hides nothing. Its slope as the light sees it, the size of the map and the filter vary.
TEST(ShadowBias, ByDefaultNoSurfaceShadowsItself) {
  constexpr unsigned seed = 11;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  int with_none = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const auto number = [&] { return std::to_string(anywhere(random)); };
    // From 18 to 0.018 units: a bias in world units would fit one of them at most.
    const double scale = trial % 3 == 0 ? 1 : trial % 3 == 1 ? 0.1 : 0.001;
    const auto scaled = [&](double value) { return std::to_string(value * scale); };
    const std::string light =
        trial % 2 == 0
            ? "light { type = directional intensity = 0.7 direction = (" + number() + ", 0.9, " + number() + ") }"
            : "light { type = point intensity = 0.7 position = (" + scaled(3 * anywhere(random)) + "," + scaled(2.5) +
                  "," + scaled(6 + 4 * anywhere(random)) + ") }";
    const Scene scene =
        parse_scene("rectangle { corner=(" + scaled(-9) + "," + scaled(-1) + "," + scaled(1) + ") side_a=(0,0," +
                        scaled(18) + ") side_b=(" + scaled(18) + ",0,0) color=white }" + light,
                    "floor.scene", ".");
    Settings settings = with_maps(trial % 2 == 0 ? 256 : 64, 1 + 2 * (trial % 4));
    settings.near = 0.0001;
    EXPECT_EQ(dark_pixels(shadow_picture(scene, settings)), 0)
        << "seed " << seed << ", trial " << trial << ": " << light;
    settings.shadow_slope_bias = 0;
    with_none += dark_pixels(shadow_picture(scene, settings));
  }
  EXPECT_GT(with_none, 1000) << "there must be acne to cure";
}

/// Pixels in which a picture differs from shadow rays by more than 30 levels, of the surfaces that both show.
int wrong_pixels(const Frame& found, const Frame& rays) {
  int count = 0;
  for (int y = 0; y < rays.height(); ++y)
    for (int x = 0; x < rays.width(); ++x) {
      if (found.ids.at(x, y).object != rays.ids.at(x, y).object) continue;
      const Vec3f d =
          glm::abs(glm::clamp(found.colour.at(x, y), 0.0f, 1.0f) - glm::clamp(rays.colour.at(x, y), 0.0f, 1.0f));
      count += std::max({d.x, d.y, d.z}) * 255 > 30 ? 1 : 0;
    }
  return count;
}

TEST(ShadowBias, ByDefaultShadowsAreThoseOfShadowRays) {
  int without = 0, fixed = 0, derived = 0;
  for (const char* name : {"cgfs/shadows", "cgfs/shading", "cgfs/crates", "lab/cornell", "lab/inside-shadow",
                           "lab/stacked-shadows", "lab/tea-party", "lab/shadow-acne", "octree/attenuation"}) {
    const Scene scene = load_scene(name);
    Settings rays = settings_for(scene, Renderer::ray_tracer);
    rays.shadows = Shadows::traced;
    rays.reflection_depth = 0;
    const Frame traced = shadow_picture(scene, rays);
    Settings settings = rays;
    settings.renderer = Renderer::rasterizer;
    settings.shading = Shading::phong;
    settings.shadow_map_size = 512;
    const auto wrong = [&](Shadows shadows, double bias, double slope) {
      settings.shadows = shadows;
      settings.shadow_bias = bias;
      settings.shadow_slope_bias = slope;
      return wrong_pixels(shadow_picture(scene, settings), traced);
    };
    const int none = wrong(Shadows::none, 0, 0), constant = wrong(Shadows::map, 0.01, 0),
              needed = wrong(Shadows::map, Settings().shadow_bias, Settings().shadow_slope_bias);
    std::printf("%-20s no shadows %5d, bias 0.01 %5d, default %5d wrong pixels\n", name, none, constant, needed);
    without += none;
    fixed += constant;
    derived += needed;
  }
  EXPECT_LT(4 * derived, fixed);
  EXPECT_LT(10 * derived, without);
}

}  // namespace
}  // namespace ps::shadow_bias_test
