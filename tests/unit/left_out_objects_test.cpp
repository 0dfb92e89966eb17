// Scenes of which the rasterizer leaves out an object: the others are drawn and told as without it.
#include <gtest/gtest.h>

#include <algorithm>

#include "options/option.h"
#include "render/render.h"
#include "scene/scene_file.h"
#include "support/trials.h"

namespace ps {
namespace {

PixelStory story_of(const Scene& scene, const Settings& settings, Vec2i pixel, int size) {
  Prepared prepared;
  Progress progress;
  return inspect(scene, {scene.camera, size, size}, settings, pixel, prepared, progress);
}

/// A triangle and a ball, after a lens by CSG or without it.
Scene with_lens(bool lens) {
  return parse_scene(
      std::string("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n") +
          (lens ? "intersection { name = lens  sphere { center = (-0.9, 0, 4)  radius = 1.4  color = red }\n"
                  "  sphere { center = (0.9, 0, 4)  radius = 1.4  color = blue } }\n"
                : "") +
          "triangle { name = t  vertices = [(-2, -2, 5), (-2, 2, 5), (2, 2, 5)]  color = white }\n"
          "sphere { name = s  center = (1, -0.5, 4)  radius = 0.5  color = red }\n"
          "light { type = ambient  intensity = 0.2 }\n"
          "light { type = point  intensity = 0.5  position = (3, 2, 0) }\n",
      "lens.scene", ".");
}

// CSG is left out, so the numbers of drawn things are not those of the scene's objects.
TEST(LeftOutObjects, ChangeNothingForTheOthersAndAreTold) {
  const Scene without = with_lens(false), with = with_lens(true);
  for (const char* assignment : {"draw=wireframe", "shading=gouraud", "shading=flat", "shadows=stencil-depth-fail",
                                 "shadows=map", "shading=phong"}) {
    Settings settings;
    settings.renderer = Renderer::rasterizer;
    parse_assignment(assignment, settings);
    const auto draw = [&](const Scene& scene, Shading shading) {
      Settings own = settings;
      own.shading = shading;
      Prepared prepared;
      Progress progress;
      return render(scene, {scene.camera, 60, 60}, own, {}, prepared, progress);
    };
    for (const Shading shading : {settings.shading, Shading::gouraud}) {
      const Frame a = draw(without, shading), b = draw(with, shading);
      EXPECT_TRUE(std::equal(a.colour.pixels().begin(), a.colour.pixels().end(), b.colour.pixels().begin()))
          << assignment;
    }
    const int step = 5 + test::trial_divisor;
    for (int y = 1; y < 60; y += step)
      for (int x = 1; x < 60; x += step) {
        const PixelStory story = story_of(with, settings, {x, y}, 60);
        EXPECT_EQ(story.linear, story_of(without, settings, {x, y}, 60).linear) << assignment << " " << x << ", " << y;
        EXPECT_NE(story.verdict.find("leaves out CSG"), std::string::npos);
      }
  }
}

}  // namespace
}  // namespace ps
