#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "base/check.h"
#include "frame/prepared.h"
#include "math/unit.h"
#include "raster/setup/tessellate_solid.h"
#include "render/render.h"
#include "scene/edit.h"
#include "scene/form_frame.h"
#include "scene/obj.h"
#include "scene/scene_file.h"
#include "shade/illumination.h"
#include "shade/parallax_mapping.h"

namespace ps::short_directions_test {
namespace {

constexpr std::array<double, 6> lengths_of_directions{5e-324, 1e-300, 1e-170, 1e-162, 1e-30, 1e-12};

TEST(ShortDirections, HaveLengthOne) {
  for (const double length : lengths_of_directions) {
    const Vec3d unit = unit_of(Vec3d{0, 3, -4} * length);
    EXPECT_NEAR(dot(unit, unit), 1, 1e-15) << length;
    if (length < 1e-320) continue;  // so few digits that 3 : 4 is rounded
    EXPECT_NEAR(unit.y, 0.6, 1e-15) << length;
    EXPECT_NEAR(unit.z, -0.8, 1e-15) << length;
    EXPECT_NEAR(length_of(Vec3d{0, 3, -4} * length) / length, 5, 1e-14) << length;
  }
  EXPECT_EQ(length_of(Vec3d(0)), 0);
  EXPECT_NEAR(length_of(Vec3d{3e200, 4e200, 0}) / 1e200, 5, 1e-14);
}

/// One scene for each place in which a scene file holds a direction; %d stands for a number however small.
const std::array<std::string, 6> places_of_directions{
    "plane { point=(0,-1,0) normal=(0,%d,0) }",
    "cylinder { from=(0,0,3) to=(0,%d,3) radius=1 }",
    "rectangle { corner=(0,0,3) side_a=(%d,0,0) side_b=(0,%d,0) }",
    "sphere { center=(0,0,3) radius=1 specular=10 } light { type=directional intensity=0.5 direction=(%d,%d,-%d) }",
    "camera { position=(0,0,0) look_at=(0,0,%d) up=(0,%d,0) } sphere { center=(0,0,3) radius=1 }",
    "triangle { vertices=[(0,0,3),(0,1,3),(1,0,3)] normals=[(0,0,-%d),(0,0,-%d),(0,0,-%d)] color=red }"};

Scene scene_of(std::string text, double length) {
  char number[32];
  std::snprintf(number, sizeof number, "%.17g", length);
  for (auto at = text.find("%d"); at != std::string::npos; at = text.find("%d")) text.replace(at, 2, number);
  return parse_scene(text + " light { type=point intensity=0.5 position=(1,2,0) }", "short.scene", ".");
}

Frame picture_of(const Scene& scene, Renderer renderer, Shadows shadows) {
  Settings settings{.renderer = renderer};
  settings.shadows = shadows;
  settings.shadow_map_size = 64;
  return render(scene, {scene.camera, 24, 18}, settings);
}

TEST(ShortDirections, DrawAsTheirLongerOnes) {
  for (const std::string& text : places_of_directions)
    for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer})
      for (const double length : lengths_of_directions) {
        const Scene scene = scene_of(text, length);
        const Frame frame =
            picture_of(scene, renderer, renderer == Renderer::rasterizer ? Shadows::map : Shadows::none);
        const bool keeps_length = text.starts_with("cylinder") || text.starts_with("rectangle");
        const Frame wanted = keeps_length ? frame
                                          : picture_of(scene_of(text, 1), renderer,
                                                       renderer == Renderer::rasterizer ? Shadows::map : Shadows::none);
        for (int y = 0; y < 18; ++y)
          for (int x = 0; x < 24; ++x)
            for (int c = 0; c < 3; ++c) {
              const float found = frame.colour.at(x, y)[c];
              ASSERT_TRUE(std::isfinite(found)) << text << " with " << length;
              ASSERT_NEAR(found, wanted.colour.at(x, y)[c], 1e-4) << text << " with " << length;
            }
      }
}

TEST(ShortDirections, OfObjFilesAreBroughtToALengthThatFloatsSquare) {
  const ObjModel model = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1e-170\nf 1//1 2//1 3//1\n", "short.obj");
  ASSERT_EQ(model.mesh.normals.size(), 1u);
  EXPECT_GE(model.mesh.normals[0].z, 0.5);
  EXPECT_EQ(model.mesh.triangles.at(0).normal[0], 0);
}

TEST(ShortDirections, OfTheCameraAreRefusedWhereTheirLengthCounts) {
  const auto refused = [](const std::string& text) {
    EXPECT_THROW(parse_scene(text, "short.scene", "."), InputError) << text;
  };
  refused("camera { right=(1,0,0) up=(0,1,0) forward=(0,0,1e-170) }");
  refused("camera { rotation=[(1,0,0),(0,1,0),(0,0,0)] }");
  refused("box { center=(0,0,4) size=(1,1,1) rotation=[(0,0,0),(0,0,0),(0,0,0)] }");
  Scene scene = parse_scene("camera { position=(0,0,0) }", "short.scene", ".");
  EXPECT_THROW(set_property(scene, "camera.forward", "(0,0,1e-30)"), InputError);
}

TEST(ShortDirections, OfACameraOfManyUnitsLieInNoPlane) {
  Scene scene = parse_scene("sphere { center=(0,0,3) radius=1 }", "short.scene", ".");
  scene.camera.right *= 1e-6;
  scene.camera.up *= 1e-6;
  scene.camera.forward *= 1e-6;
  EXPECT_NO_THROW(picture_of(scene, Renderer::rasterizer, Shadows::none));
}

TEST(ShortDirections, TheTessellatorRefusesWhatIsNotFinite) {
  raster::TessellationView view;
  Solid solid;
  solid.form = Plane{{0, std::numeric_limits<double>::quiet_NaN(), 0}, {0, 1, 0}};
  EXPECT_THROW(raster::tessellate_solid(solid, view), InputError);
  solid.form = Plane{{0, -1, 0}, {0, 1, 0}};
  view.nearest = std::numeric_limits<double>::infinity();
  EXPECT_THROW(raster::tessellate_solid(solid, view), InputError);
}

TEST(ShortDirections, AttenuationThatFloatsRoundToNothingStaysFinite) {
  const Scene scene =
      parse_scene("light { type=point position=(0,0,4) intensity=1e12 attenuation=(0,0,5e-324) }"
                  "light { type=point position=(0,0,4) intensity=0 attenuation=(0,0,5e-324) }"
                  "sphere { center=(0,0,5) radius=1 specular=1e-300 color=red }"
                  "light { type=point intensity=0.6 position=(1,2,0) } light { type=ambient intensity=0.2 }"
                  "light { type=directional intensity=0.3 direction=(1,4,4) }",
                  "bright.scene", ".");
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    const Frame frame = picture_of(scene, renderer, Shadows::none);
    for (const Vec3f& pixel : frame.colour.pixels())
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(pixel[c]));
  }
}

/// The light of a lamp at this distance, against the formulas in double, in which no square of a float is lost.
template <class Real>
void expect_arrivals() {
  for (const double distance : {1e-36, 1e-25, 1e-20, 1e-17, 1e-8, 1.0, 1e8, 1e17, 1e20, 1e25, 1e36})
    for (const Vec3d& attenuation : {Vec3d{0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}, {1, 1e-20, 0}, {0.5, 1e20, 1e30}}) {
      ShadingLight<Real> lamp;
      lamp.kind = LightKind::point;
      lamp.intensity = Real(0.75);
      lamp.attenuation = Vec3<Real>(attenuation);
      lamp.attenuates = true;
      const Vec3<Real> to_light = Vec3<Real>(Vec3d{0.36, -0.48, 0.8} * distance);
      const double divisor = attenuation.x + attenuation.y * distance + attenuation.z * distance * distance;
      const double book = std::min(0.75 / divisor, 1e12);
      EXPECT_NEAR(arriving(lamp, to_light, {}) / book, 1, book < 1e-37 ? 1 : 1e-5) << distance << " " << attenuation.y;
      IlluminationOptions radiometric;
      radiometric.illumination = Illumination::radiometric;
      const double watts = std::min(0.75 / (4 * 3.14159265358979) / distance / distance, 1e12);
      EXPECT_NEAR(arriving(lamp, to_light, radiometric) / watts, 1, watts < 1e-37 ? 1 : 1e-5) << distance;
    }
}

TEST(ShortDirections, LampsOfAnyDistanceShineAsTheirFormulasSay) {
  expect_arrivals<float>();
  expect_arrivals<double>();
}

/// A relief is seen at the same place of its texture, however large the triangle, and its texture coordinates, are.
TEST(ShortDirections, FramesOfTexturesKeepTheirShape) {
  const std::array<Vec3f, 3> corners{Vec3f{0, 0, 0}, {3, 0, 0}, {1, 2, 0}};
  const std::array<Vec2f, 3> uvs{Vec2f{0, 0}, {0.5f, 0.25f}, {0, 1}};
  const Vec3f normal{0, 0, 1}, to_eye{0.5f, 0.25f, 1};
  const auto shift = [&](float length, float span) {
    std::array<Vec3f, 3> p = corners;
    std::array<Vec2f, 3> t = uvs;
    for (std::size_t i = 0; i < 3; ++i) p[i] *= length, t[i] *= span;
    const auto frame = triangle_frame(p, t);
    return frame ? relief_shift(normal, *frame, to_eye, 0.5f, Parallax::occlusion).value_or(Vec2f(9)) : Vec2f(9);
  };
  const Vec2f wanted = shift(1, 1);
  EXPECT_LT(std::abs(wanted.x) + std::abs(wanted.y), 1);
  for (const float length : {0x1p-120f, 0x1p-70f, 0x1p-24f, 0x1p14f, 0x1p60f, 0x1p120f})
    for (const float span : {0x1p-120f, 0x1p-70f, 0x1p-24f, 1.0f, 0x1p14f, 0x1p60f, 0x1p120f})
      EXPECT_EQ(shift(length, span), wanted) << length << " " << span;
}

}  // namespace
}  // namespace ps::short_directions_test
