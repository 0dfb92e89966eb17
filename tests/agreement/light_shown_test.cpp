// The pass of each light alone: light adds up, so the pictures of all lights do.
#include <gtest/gtest.h>

#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::light_shown_test {
namespace {

Frame draw(const Scene& scene, const Settings& settings, Prepared& prepared) {
  Progress progress;
  RenderRequest request;
  if (settings.renderer == Renderer::rasterizer && settings.shadows == Shadows::stencil_depth_fail)
    request.channels = Channel::stencil;
  return render(scene, {scene.camera, 120, 80}, settings, request, prepared, progress);
}

TEST(LightShown, PassesOfSingleLightsAddUpToThePicture) {
  for (const std::vector<const char*>& how : {std::vector<const char*>{"renderer=ray-tracer"},
                                              {"renderer=ray-tracer", "simd=off"},
                                              {"renderer=rasterizer", "shadows=none"},
                                              {"renderer=rasterizer", "shading=gouraud", "shadows=none"},
                                              {"renderer=rasterizer", "shadows=map"},
                                              {"renderer=rasterizer", "light-passes=many", "shadows=none"},
                                              {"renderer=rasterizer", "shadows=stencil-depth-fail"}}) {
    Scene scene = load_scene("cgfs/shadows");
    scene.background = Vec3d(0);
    Settings settings = settings_for(scene);
    std::string name;
    for (const char* assignment : how) {
      parse_assignment(assignment, settings);
      name += std::string(assignment) + " ";
    }
    SCOPED_TRACE(name);
    Prepared prepared;  // one for all: nothing that is kept may belong to another light
    const Frame whole = draw(scene, settings, prepared);
    const auto lights = static_cast<int>(scene.lights->size());
    ASSERT_EQ(lights, 3);
    Image<Vec3f> sum(120, 80);
    Image<std::int32_t> counts(120, 80);
    double least_share = 1e9;
    for (settings.light_shown = 0; settings.light_shown < lights; ++settings.light_shown) {
      const Frame alone = draw(scene, settings, prepared);
      double light = 0;
      for (std::size_t i = 0; i < sum.pixels().size(); ++i) {
        sum.pixels()[i] += alone.colour.pixels()[i];
        light += static_cast<double>(alone.colour.pixels()[i].x);
        if (!alone.stencil.empty()) counts.pixels()[i] += alone.stencil.pixels()[i];
      }
      least_share = std::min(least_share, light);
    }
    EXPECT_GT(least_share, 10) << "each light lights something";
    for (std::size_t i = 0; i < sum.pixels().size(); ++i) {
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(sum.pixels()[i][c], whole.colour.pixels()[i][c], 3e-6) << i;
      if (!whole.stencil.empty()) {
        ASSERT_EQ(counts.pixels()[i], whole.stencil.pixels()[i]) << i;
      }
    }
    settings.light_shown = lights;
    const Frame dark = draw(scene, settings, prepared);
    for (const Vec3f& colour : dark.colour.pixels()) ASSERT_EQ(colour, Vec3f(0));
  }
}

}  // namespace
}  // namespace ps::light_shown_test
