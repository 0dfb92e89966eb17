// What a driver has no room for ends in a message that says so, and the renderer goes on.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "agreement/hardware/hardware_pair.h"
#include "base/check.h"
#include "hardware/gl_thread.h"
#include "hardware/render.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/refusal.h"
#include "support/settings_with.h"

namespace ps {
namespace {

std::string failure_of(const Scene& scene, int width, int height, Renderer hardware) {
  Settings settings = settings_for(scene, hardware);
  return test::refusal_of([&] { render(scene, {scene.camera, width, height}, settings); });
}

TEST(HardwareLimits, MoreLightsThanAUniformBlockHolds) {
  PS_NEEDS_HARDWARE(hardware);
  const int most = hardware::availability().driver->max_block_bytes / 48;
  Scene scene = load_scene("cgfs/shading");
  scene.lights.edit([&](std::vector<Light>& lights) {
    lights.assign(static_cast<std::size_t>(most), Light{LightKind::ambient, 0.5 / most});
  });
  EXPECT_EQ(failure_of(scene, 40, 30, hardware), "");
  scene.lights.edit([&](std::vector<Light>& lights) { lights.push_back(lights.front()); });
  EXPECT_EQ(failure_of(scene, 40, 30, hardware),
            fmt::format("{} lights: this graphics driver holds at most {} of them in a uniform block", most + 1, most));
  EXPECT_EQ(failure_of(scene, 40, 30, Renderer::rasterizer), "");
  EXPECT_EQ(failure_of(load_scene("cgfs/shading"), 40, 30, hardware), "");
}

/// Each from another direction: were a few of them cut off, or read in the place of others, the picture would differ.
TEST(HardwareLimits, AThousandLights) {
  PS_NEEDS_HARDWARE(hardware);
  constexpr int count = 1000;
  if (hardware::availability().driver->max_block_bytes < 48 * count) GTEST_SKIP() << "this driver holds fewer";
  Scene scene = load_scene("cgfs/shading");
  scene.lights.edit([&](std::vector<Light>& lights) {
    lights.clear();
    for (int i = 0; i < count; ++i) {
      Light light{LightKind::directional, 3.0 / count};
      light.direction = {std::cos(i * 0.37), 0.5 + std::sin(i * 0.11), -1};
      lights.push_back(light);
    }
  });
  const test::PairDifference difference = test::compare_with_rasterizer(scene, settings_for(scene), hardware, 120, 90);
  EXPECT_GT(difference.seen, 1000) << difference.text();
  EXPECT_LE(difference.ids, 2) << difference.text();
  EXPECT_LE(difference.colours, 2) << difference.text();
}

TEST(HardwareLimits, ATextureLargerThanTheDriverHolds) {
  PS_NEEDS_HARDWARE(hardware);
  const int most = hardware::availability().driver->max_size;
  Scene scene = load_scene("cgfs/crates");
  scene.textures.edit([&](std::vector<Texture>& textures) {
    for (Texture& texture : textures) texture.texels = std::make_shared<const Image<Vec3f>>(most + 1, 1, Vec3f(0.5f));
  });
  const std::string failure = failure_of(scene, 40, 30, hardware);
  EXPECT_NE(failure.find(fmt::format("a texture of {} x 1 texels", most + 1)), std::string::npos) << failure;
  EXPECT_NE(failure.find(fmt::format("this graphics driver holds at most {}", most)), std::string::npos) << failure;
  EXPECT_EQ(failure_of(scene, 40, 30, Renderer::rasterizer), "");
  EXPECT_EQ(failure_of(load_scene("cgfs/crates"), 40, 30, hardware), "");
}

TEST(HardwareLimits, APictureLargerThanTheDriverDraws) {
  PS_NEEDS_HARDWARE(hardware);
  const int most = hardware::availability().driver->max_size;
  EXPECT_EQ(
      failure_of(load_scene("cgfs/shading"), most + 1, 1, hardware),
      fmt::format("a picture of {} x 1 pixels: this graphics driver draws at most {} along a side", most + 1, most));
}

// Before anything of the picture is made: a driver that refuses does so within no memory of ours.
TEST(HardwareLimits, APictureThatTheDriverHasNoRoomFor) {
  PS_NEEDS_HARDWARE(hardware);
  const int most = hardware::availability().driver->max_size;
  try {
    hardware::require_driver(View{.camera = {}, .width = most, .height = most});
    GTEST_SKIP() << "this driver has room for " << most << " x " << most << " pixels";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), fmt::format("a picture of {0} x {0} pixels: this graphics driver has no room to draw it; "
                                        "choose a smaller size",
                                        most));
  }
  EXPECT_EQ(failure_of(load_scene("cgfs/shading"), 40, 30, hardware), "");
}

/// A value that the driver lacks is inactive, and a picture of it is refused.
TEST(HardwareLimits, ANumberOfSamplesThatTheDriverDoesNotOffer) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<int>& offered = hardware::availability().driver->samples;
  const Scene scene = load_scene("cgfs/shading");
  for (const int samples : {2, 4, 8}) {
    Settings settings = settings_for(scene, hardware);
    settings.multisampling = samples;
    const bool has = std::find(offered.begin(), offered.end(), samples) != offered.end();
    EXPECT_EQ(inactive_value_reason(*find_option("multisampling"), settings, scene_traits(scene)).has_value(), !has);
    if (has)
      EXPECT_NO_THROW(render(scene, {scene.camera, 40, 30}, settings));
    else
      EXPECT_THROW(render(scene, {scene.camera, 40, 30}, settings), InputError);
  }
}

}  // namespace
}  // namespace ps
