#include <gtest/gtest.h>

#include <string>

#include "base/available_memory.h"
#include "base/check.h"
#include "frame/prepared.h"
#include "raster/maps.h"
#include "render/render.h"
#include "scene/scene_file.h"
#include "support/refusal.h"

namespace ps::shadow_map_memory_test {
namespace {

Scene scene_with_lights(int points) {
  std::string text = "sphere { center=(0,0,3) radius=1 } light { type = ambient intensity = 0.1 }"
                     "light { type = directional intensity = 0.1 direction = (1,4,-4) }";
  for (int i = 0; i < points; ++i) text += " light { type = point intensity = 0.1 position = (1,2,0) }";
  return parse_scene(text, "lights.scene", ".");
}

Settings with_maps(int size) {
  Settings settings{.renderer = Renderer::rasterizer};
  settings.shadows = Shadows::map;
  settings.shadow_map_size = size;
  return settings;
}

/// What refuses with `available` bytes says; empty where it does not.
std::string refusal(std::uint64_t needed, std::optional<std::uint64_t> available) {
  return test::refusal_of([&] { require_memory(needed, available, "the maps", "have fewer lights"); });
}

TEST(ShadowMapMemory, IsWhatTheMapsTake) {
  const Scene scene = scene_with_lights(3);
  Prepared prepared;
  Progress progress;
  const auto maps = raster::shadow_maps(scene, with_maps(64), prepared, WorkerPriority::normal, progress);
  std::size_t bytes = 0;
  for (const raster::ShadowMap& map : *maps)
    for (const auto& face : map.faces) bytes += face.pixels().size_bytes();
  EXPECT_EQ(bytes, (3u * 6 + 1) * 64 * 64 * 4);
  EXPECT_GE(raster::shadow_map_bytes(*scene.lights, 64), bytes);
  EXPECT_LE(raster::shadow_map_bytes(*scene.lights, 64), bytes + 6u * 64 * 64 * 4);
}

TEST(ShadowMapMemory, RefusesMoreThanThereIsAndSaysHowMuch) {
  constexpr std::uint64_t gigabyte = 1'000'000'000;
  EXPECT_EQ(refusal(16 * gigabyte, 8 * gigabyte),
            "the maps need 16 GB of memory, and this computer can spare 6 GB: have fewer lights");
  EXPECT_EQ(refusal(5 * gigabyte, 8 * gigabyte), "");
  EXPECT_EQ(refusal(16 * gigabyte, {}), "");
  EXPECT_EQ(refusal(1'000'000, 1000), "") << "a megabyte is no reason to refuse";
}

TEST(ShadowMapMemory, AThousandLightsAreRefusedBeforeTheFirstMap) {
  if (!available_memory() || *available_memory() > 500'000'000'000u) GTEST_SKIP() << "this computer could hold them";
  const Scene scene = scene_with_lights(998);
  const std::string message = test::refusal_of([&] { render(scene, {scene.camera, 8, 8}, with_maps(4096)); });
  EXPECT_NE(message.find("the shadow maps of 999 lights with 4096 x 4096 texels need 402 GB"), std::string::npos)
      << message;
}

}  // namespace
}  // namespace ps::shadow_map_memory_test
