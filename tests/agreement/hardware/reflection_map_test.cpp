// Pictures of the surroundings in a material (MTL: refl): the graphics driver shows what the rasterizer shows, the
// story of a pixel ends with the colour of the picture, and no renderer says that it leaves reflections out.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "agreement/hardware/hardware_pair.h"
#include "base/atomic_file.h"
#include "options/option.h"
#include "render/left_out.h"
#include "render/render.h"
#include "render/story/story_tree.h"
#include "scene/scene_file.h"
#include "support/golden.h"
#include "support/settings_with.h"

namespace ps::hardware_reflection_map_test {
namespace {

constexpr int width = 96, height = 72;

/// A ball that shows a map of the world, a wall that shows a cross, and a mirror without a picture if asked for.
Scene scene_of_maps(bool mirror) {
  const auto folder = fresh_output_folder("reflection-maps");
  std::string picture = "P3 64 48 255\n";  // changes slowly, and has no two equal places
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto wave = [](double at) { return static_cast<int>(127.5 + 127.5 * std::sin(at)); };
      picture += fmt::format("{} {} {}\n", wave(0.11 * x), wave(0.17 * y), wave(0.05 * (x + 2 * y)));
    }
  write_file_atomically(folder / "t.ppm", picture);
  const std::string text =
      "background = linear (0.1, 0.2, 0.3)\ntexture { name = t file = t.ppm }\n"
      "material { name = world  color = red  specular = 20  reflective = 0.6  reflection_map = t }\n"
      "material { name = cross  color = green  reflective = 0.8  reflection_map = t  surroundings = cube }\n"
      "sphere { center = (-0.7, 0, 3) radius = 0.9 material = world }\n"
      "model { name = wall  material = cross  vertices = [(0, -1.6, 4), (0, 1.6, 4), (2.4, 1.6, 2), (2.4, -1.6, 2)]\n"
      "  normals = [(-0.6, 0.3, -0.8), (-0.9, -0.2, -0.6), (0.1, 0.3, -1), (-0.2, -0.4, -1)]\n"
      "  triangles { 0 = { vertices = [0, 1, 2] normals = [0, 1, 2] } 1 = { vertices = [0, 2, 3] normals = [0, 2, 3] } "
      "} }\ninstance { model = wall }\n"
      "light { type = ambient intensity = 0.2 }\nlight { type = point intensity = 0.6 position = (2, 2, 0) }\n"
      "light { type = directional intensity = 0.3 direction = (-1, 1, -2) }\n";
  const std::string more = "sphere { center = (0.2, -0.6, 2) radius = 0.3 color = white reflective = 0.5 }\n";
  return parse_scene(mirror ? text + more : text, "maps.scene", folder.string());
}

TEST(HardwareReflectionMap, ShowsWhatTheRasterizerShows) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<std::vector<const char*>> cases{
      {},
      {"shading=gouraud"},
      {"shading=flat"},
      {"lighting=off"},
      {"texture-filter=bilinear"},
      {"texture-filter=nearest"},
      {"hardware-texturing=driver"},
      {"light-passes=many"},
      {"deferred-shading=on"},
      {"deferred-shading=on", "shading=gouraud"},
      {"early-depth=on", "projection=orthographic"},
      {"shadows=stencil-depth-fail"},
      {"reflection-depth=0"},
      {"textures=off"},
  };
  for (const bool mirror : {false, true})
    for (std::size_t i = 0; i < cases.size(); i += mirror ? 8 : 1) {  // among them deferred shading
      const auto& assignments = cases[i];
      const Scene scene = scene_of_maps(mirror);
      Settings settings = settings_with({.renderer = hardware}, assignments);
      if (mirror) settings.environment = Environment::cube_map;
      const test::PairDifference difference = test::compare_with_rasterizer(scene, settings, hardware, width, height);
      EXPECT_LE(difference.ids + difference.colours, 60)
          << fmt::format("{} {}: {}", fmt::join(assignments, " "), mirror, difference.text());
      EXPECT_GT(difference.seen, 2000);
    }
  // The map makes a difference at all.
  const Scene scene = scene_of_maps(false);
  const View view{scene.camera, width, height};
  const Frame maps = render(scene, view, Settings{.renderer = hardware}),
              none = render(scene, view, settings_with({.renderer = hardware}, {"textures=off"}));
  long differ = 0;
  for (std::size_t i = 0; i < maps.colour.pixels().size(); ++i)
    differ += length(maps.colour.pixels()[i] - none.colour.pixels()[i]) > 0.1f;
  EXPECT_GT(differ, 1500);
}

TEST(HardwareReflectionMap, TheStoryEndsWithThePicturesColour) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = scene_of_maps(false);
  const View view{scene.camera, width, height};
  for (const auto& assignments :
       std::vector<std::vector<const char*>>{{}, {"light-passes=many"}, {"deferred-shading=on"}, {"shading=gouraud"}}) {
    const Settings settings = settings_with({.renderer = hardware}, assignments);
    Prepared prepared;
    Progress progress;
    const Frame frame = render(scene, view, settings, {}, prepared, progress);
    int reflected = 0;
    for (int y = 3; y < height; y += 11)
      for (int x = 3; x < width; x += 11) {
        const PixelStory story = inspect(scene, view, settings, {x, y}, prepared, progress);
        EXPECT_EQ(Vec3f(story.linear), frame.colour.at(x, y)) << x << "," << y;
        for (const auto* mixed : events_of<ReflectionEvent>(story.events)) {
          ++reflected;
          const Vec3d sum = mixed->local * (1 - mixed->reflective) + mixed->reflected * mixed->reflective;
          EXPECT_LT(length(sum - mixed->result), 1e-5) << x << "," << y;
          EXPECT_TRUE(std::any_of(
              story.ledger.begin(), story.ledger.end(),
              [](const LedgerLine& line) { return line.term.ends_with(" x colour from its reflection map t"); }))
              << x << "," << y;
        }
      }
    EXPECT_GT(reflected, 10);
  }
}

// A picture takes the place of the scene in the mirror, for every renderer: nothing is left out then.
TEST(HardwareReflectionMap, NothingIsLeftOut) {
  PS_NEEDS_HARDWARE(hardware);
  for (const Renderer renderer : {hardware, Renderer::rasterizer}) {
    const Settings settings = settings_with({.renderer = renderer}, {"shadows=none"});
    EXPECT_EQ(left_out_words(scene_traits(scene_of_maps(false)), settings), "");
    const std::string words = left_out_words(scene_traits(scene_of_maps(true)), settings);
    EXPECT_NE(words.find("leaves out reflections"), std::string::npos) << words;
    const Settings unread = settings_with({.renderer = renderer}, {"shadows=none", "textures=off"});
    EXPECT_NE(left_out_words(scene_traits(scene_of_maps(false)), unread).find("reflections"), std::string::npos);
  }
}

}  // namespace
}  // namespace ps::hardware_reflection_map_test
