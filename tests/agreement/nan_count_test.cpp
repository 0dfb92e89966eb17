// The number of pixels that are not a number is that of the picture, whichever code draws it.
#include <gtest/gtest.h>

#include "image/display.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/scene_file.h"
#include "support/settings_with.h"
#include "support/simd_targets.h"

namespace ps::nan_count_test {
namespace {

TEST(NanCount, IsThatOfThePictureOnEveryTarget) {
  const Scene scene = parse_scene(R"(
texture { name = nan  file = "special.pfm" }
sphere { center = (0, 0, 3)  radius = 1  texture = nan }
sphere { center = (1, 0, 4)  radius = 1  color = red }
light { type = ambient  intensity = 1 }
)",
                                  "nan.scene", "tests/corpus/pfm");
  std::vector<Simd> targets = test::simd_targets();
  targets.push_back(Simd::off);
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer})
    for (const Simd target : targets) {
      Settings settings = settings_for(scene, renderer);
      settings.simd = target;
      const Frame frame = render(scene, {scene.camera, 90, 70}, settings);
      EXPECT_GT(frame.counters[Counter::nan_pixels], 300U);
      EXPECT_EQ(frame.counters[Counter::nan_pixels], count_nan_pixels(frame.colour))
          << static_cast<int>(renderer) << ", SIMD target " << static_cast<int>(target);
    }
}

}  // namespace
}  // namespace ps::nan_count_test
