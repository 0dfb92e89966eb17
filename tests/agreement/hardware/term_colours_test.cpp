// Colours of a light's terms, the diffuse term switched off, and mapped normals by the inverse transpose: the graphics
// driver shows what the rasterizer shows, however its passes divide the light.
#include <gtest/gtest.h>

#include <iostream>

#include "agreement/hardware/hardware_pair.h"
#include "options/option.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"

namespace ps::hardware_term_colours_test {
namespace {

constexpr int width = 120, height = 90;

Scene two_lights() {
  return parse_scene("viewport_size = 1.2 x 0.9\nprojection_plane_d = 1\nbackground = linear (0.1, 0.1, 0.1)\n"
                     "material { name = clay  color = linear (0.5, 0.4, 0.8)  specular = 8 }\n"
                     "model { name = wall  materials = [clay]\n"
                     "  vertices { 0 = (-3, -3, 4)  1 = (-3, 3, 4)  2 = (3, 3, 5)  3 = (3, -3, 5) }\n"
                     "  triangles { 0 = { vertices = [0, 1, 2] }  1 = { vertices = [0, 2, 3] } }\n}\n"
                     "instance { model = wall }\n"
                     "sphere { center = (0.4, 0.3, 2.5)  radius = 0.4  material = clay }\n"
                     "light { type = point  intensity = 0.7  position = (1, 2, -1)  color = linear (0.9, 0.2, 0.1)\n"
                     "        specular_color = linear (0.1, 0.8, 0.3)  ambient_color = linear (0.05, 0.1, 0.4)\n"
                     "        attenuation = (1, 0.1, 0.05) }\n"
                     "light { type = directional  intensity = 0.4  direction = (-1, 1, -2)\n"
                     "        ambient_color = linear (0.3, 0, 0) }\n",
                     "two.scene", ".");
}

TEST(HardwareTermColours, AreTheRasterizersInAllPasses) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = two_lights();
  for (const std::vector<std::string>& assignments :
       std::vector<std::vector<std::string>>{{"shadows=none"},
                                             {"shadows=none", "light-passes=many"},
                                             {"shadows=none", "deferred-shading=on"},
                                             {"shadows=none", "shading=gouraud"},
                                             {"shadows=map", "shadow-map-size=256"},
                                             {"shadows=map", "shadow-map-size=256", "shading=flat"},
                                             {"shadows=stencil-depth-fail"},
                                             {"shadows=stencil-depth-fail", "shading=gouraud"},
                                             {"shadows=none", "diffuse=off"},
                                             {"shadows=none", "diffuse=off", "illumination=radiometric"}}) {
    Settings settings;
    std::string name;
    for (const std::string& assignment : assignments) {
      parse_assignment(assignment, settings);
      name += assignment + " ";
    }
    const test::PairDifference difference = test::compare_with_rasterizer(scene, settings, hardware, width, height);
    std::cout << name << difference.text() << "\n";
    EXPECT_GT(difference.seen, difference.pixels / 2) << name;
    EXPECT_LT(difference.colours, difference.seen / 50) << name << difference.text();
  }
}

TEST(HardwareTermColours, MappedNormalsAreTheRasterizers) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene(PIXELSCOPE_TEST_DIR "/support/stretched_relief.scene");
  for (const char* how : {"mapped-normals=world-frame", "mapped-normals=inverse-transpose"}) {
    Settings settings;
    parse_assignment(how, settings);
    const test::PairDifference difference = test::compare_with_rasterizer(scene, settings, hardware, width, height);
    std::cout << how << " " << difference.text() << "\n";
    EXPECT_LT(difference.colours, difference.seen / 50) << how << difference.text();
  }
}

// What a story reports of the ambient light of a lamp is what the rasterizer's does.
TEST(HardwareTermColours, StoriesReportTheAmbientLight) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = two_lights();
  Settings settings;
  settings.shadows = Shadows::none;
  const auto ambient = [&](Renderer renderer) {
    settings.renderer = renderer;
    std::vector<double> all;
    for (const Event& event : inspect(scene, {scene.camera, width, height}, settings, {20, 60}).events)
      if (const auto* light = std::get_if<LightEvent>(&event.data)) all.push_back(light->ambient);
    return all;
  };
  const std::vector<double> theirs = ambient(hardware), ours = ambient(Renderer::rasterizer);
  ASSERT_EQ(ours.size(), 2u);
  ASSERT_EQ(theirs.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(ours[i], 0);
    EXPECT_NEAR(theirs[i], ours[i], 1e-4 * ours[i]);
  }
}

}  // namespace
}  // namespace ps::hardware_term_colours_test
