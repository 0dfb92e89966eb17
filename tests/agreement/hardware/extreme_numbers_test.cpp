// Lengths whose squares leave the range of float, in what a graphics driver computes: distances of lights, sizes of
// models, and the frames in which textures lie on their triangles.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "agreement/hardware/hardware_pair.h"
#include "base/atomic_file.h"
#include "options/option.h"
#include "render/render.h"
#include "scene/scene_file.h"
#include "support/golden.h"

namespace ps::hardware_extreme_numbers_test {
namespace {

constexpr int picture_side = 65;

/// A white square of 2 units under ambient light and a point light right before its middle, seen from 3 units away. The
/// pixel in the middle of the picture shows where they are nearest.
Scene lit_square(double distance, const std::string& light) {
  return parse_scene(
      fmt::format("camera {{ position = (0,0,3) right = (1,0,0) up = (0,1,0) forward = (0,0,-1) }} model {{ name = q "
                  "color = white vertices {{ (-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0) }} triangles {{ (0,1,2,white) "
                  "(0,2,3,white) }} }} instance {{ model = q }} light {{ type = ambient intensity = 0.2 }} "
                  "light {{ type = point position = (0,0,{:.17g}) {} }}",
                  distance, light),
      "square.scene", ".");
}

float middle_of(const Scene& scene, Renderer renderer, const std::vector<const char*>& assignments) {
  Settings settings{.renderer = renderer};
  settings.shadows = Shadows::none;
  for (const char* one : assignments) parse_assignment(one, settings);
  return render(scene, {scene.camera, picture_side, picture_side}, settings)
      .colour.at(picture_side / 2, picture_side / 2)
      .x;
}

TEST(HardwareExtremeNumbers, ALightRightBeforeASurfaceLightsIt) {
  PS_NEEDS_HARDWARE(hardware);
  for (const double distance : {1.0, 1e-3, 1e-8, 1e-12, 1e-20, 1e-25, 1e-36})
    for (const char* way : {"highlight=phong", "highlight=blinn-phong", "deferred-shading=on", "light-passes=many",
                            "multisampling=4", "projection=orthographic", "shadows=map"})
      for (const Renderer renderer : {hardware, Renderer::rasterizer})
        EXPECT_NEAR(middle_of(lit_square(distance, "intensity = 0.8"), renderer, {way}), 1, 1e-5)
            << distance << " " << way << " " << static_cast<int>(renderer);
}

TEST(HardwareExtremeNumbers, LightsOfAnyDistanceShineAsTheirFormulasSay) {
  PS_NEEDS_HARDWARE(hardware);
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer, hardware}) {
    for (const double distance : {1e-36, 1e-25, 1e-20, 1e-17, 1e-8, 1.0, 1e3, 1e9, 1e11}) {
      // Each formula gives 1/2, though a square or its reciprocal may leave the range of float.
      const double near = std::min(distance, 1.0), far = std::max(distance, 1.0);
      const Scene linear = lit_square(
          distance, fmt::format("intensity = {:.17g} attenuation = (0,{:.17g},0)", near / 2, near / distance));
      EXPECT_NEAR(middle_of(linear, renderer, {}), 0.7, 1e-5) << distance << " " << static_cast<int>(renderer);
      if (far > 1e5 || near < 1e-18) continue;  // no scene file, or no float, holds the factors
      const Scene square = lit_square(distance, fmt::format("intensity = {:.17g} attenuation = (0,0,{:.17g})",
                                                            near * near / 2, near / distance * (near / distance)));
      EXPECT_NEAR(middle_of(square, renderer, {}), 0.7, 1e-5) << distance << " " << static_cast<int>(renderer);
      const double watts = 2 * 3.14159265358979 * 3.14159265358979 * distance * distance;
      EXPECT_NEAR(middle_of(lit_square(distance, fmt::format("intensity = {:.17g}", watts)), renderer,
                            {"illumination=radiometric"}),
                  0.7, 1e-5)
          << distance << " " << static_cast<int>(renderer);
    }
  }
}

/// Beside the light, points see it in their own plane.
TEST(HardwareExtremeNumbers, ALightNearASurfaceLightsItAsTheRasterizerDoes) {
  PS_NEEDS_HARDWARE(hardware);
  for (const char* distance : {"1e-3", "1e-9", "1e-15", "1e-20", "1e-25", "1e-36"})
    for (const char* attenuation : {"", "attenuation = (0,1,0)", "attenuation = (0,0,1)", "attenuation = (1,0,1e12)"}) {
      // Beside the pixels' centres, so that no point lies at the light itself.
      const Scene scene = parse_scene(
          fmt::format("rectangle {{ corner = (-1,-1,0) side_a = (0,2,0) side_b = (2,0,0) color = white specular = 4 }} "
                      "camera {{ position = (0,0,-3) }} light {{ type = ambient intensity = 0.3 }} "
                      "light {{ type = point intensity = 0.8 position = (0.333,0.217,-{}) {} }}",
                      distance, attenuation),
          "near.scene", ".");
      Settings settings;
      settings.shadows = Shadows::none;
      const test::PairDifference difference =
          test::compare_with_rasterizer(scene, settings, hardware, picture_side, picture_side);
      EXPECT_EQ(difference.colours, 0) << distance << " " << attenuation << ": " << difference.text();
    }
}

/// A wall with vertex normals, of this size in its model and brought to 2 units by its instance, with what `material`
/// says.
Scene wall_of(double size, double span, const std::string& material, const std::string& folder) {
  const auto n = [](double value) { return fmt::format("{:.17g}", value); };
  const std::string s = n(size), u = n(span);
  return parse_scene(
      "texture { name = t file = t.ppm } material { name = m color = white " + material + " } model { name = wall " +
          "material = m vertices = [(-" + s + ",-" + s + ",0), (-" + s + "," + s + ",0), (" + s + "," + s + ",0), (" +
          s + ",-" + s + ",0)] uvs = [(0,0),(0," + u + "),(" + u + "," + u + "),(" + u + ",0)] " +
          "normals = [(-0.6, 0.3, -0.8), (-0.4, -0.2, -0.6), (0.1, 0.3, -1), (-0.2, -0.4, -1)] triangles { "
          "0 = { vertices = [0, 1, 2] normals = [0, 1, 2] uvs = [0, 1, 2] } "
          "1 = { vertices = [0, 2, 3] normals = [0, 2, 3] uvs = [0, 2, 3] } } } instance { model = wall transform = { "
          "scale = " +
          n(1 / size) +
          " translation = (0,0,2.4) } } "
          "light { type = ambient intensity = 0.2 } light { type = point intensity = 0.7 position = (1,2,-1) }",
      "wall.scene", folder);
}

TEST(HardwareExtremeNumbers, ModelsOfAnySizeAreDrawn) {
  PS_NEEDS_HARDWARE(hardware);
  const auto folder = fresh_output_folder("hardware-extreme-numbers");
  std::string picture = "P3 16 16 255\n";
  for (int i = 0; i < 256; ++i) picture += fmt::format("{0} {0} {0}\n", 128 + (i * 37) % 64);
  write_file_atomically(folder / "t.ppm", picture);
  for (const char* material : {"texture = t", "normal_map = t", "texture = t height_map = t relief_depth = 0.05"})
    for (const double size : {1e-12, 1e-8, 1.0, 1e8, 1e12})
      for (const auto& [shading, shadows] : {std::pair{Shading::phong, Shadows::none},
                                             {Shading::flat, Shadows::none},
                                             {Shading::phong, Shadows::stencil_depth_fail}}) {
        Settings settings;
        settings.shading = shading;
        settings.shadows = shadows;
        settings.parallax = Parallax::occlusion;
        const Scene scene = wall_of(size, 1, material, folder.string());
        const test::PairDifference difference =
            test::compare_with_rasterizer(scene, settings, hardware, picture_side, picture_side);
        EXPECT_GT(difference.seen, 1000) << size << " " << material;
        EXPECT_LE(difference.ids + difference.colours, 8) << size << " " << material << ": " << difference.text();
      }
  // Texture coordinates that hardly change: one texel, the same normal everywhere.
  for (const double span : {1e-30, 1e-20, 1e-12}) {
    Settings settings;
    const test::PairDifference difference = test::compare_with_rasterizer(
        wall_of(1, span, "normal_map = t", folder.string()), settings, hardware, picture_side, picture_side);
    EXPECT_LE(difference.ids + difference.colours, 8) << span << ": " << difference.text();
  }
}

}  // namespace
}  // namespace ps::hardware_extreme_numbers_test
