// What scene and options multiply is counted before it is made, and refused in words where it cannot be had.
#include <gtest/gtest.h>

#include <string>

#include "base/available_memory.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "raster/setup/tessellate_solid.h"
#include "render/render.h"
#include "scene/scene_file.h"
#include "support/refusal.h"
#include "support/settings_with.h"

namespace ps::picture_memory_test {
namespace {

/// The refusal of a picture that would take terabytes.
std::string refusal(const std::string& scene_text, int size, const std::vector<std::string>& assignments) {
  const Scene scene = parse_scene(scene_text, "large.scene", ".");
  Settings settings = settings_with(settings_for(scene, Renderer::rasterizer), assignments);
  return test::refusal_of([&] { render(scene, {scene.camera, size, size}, settings); });
}

bool could_be_held() { return !available_memory() || *available_memory() > 100'000'000'000u; }

std::string repeated(int times, const std::string& text) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(PictureMemory, EnvironmentMapsAreAskedForBeforeTheFirst) {
  if (could_be_held()) GTEST_SKIP() << "this computer could hold them";
  const std::string mirrors = repeated(12000, "sphere { center=(0,0,9) radius=0.01 reflective=0.5 }\n");
  const std::string words = refusal(mirrors, 8, {"environment=cube-map", "environment-size=1024"});
  EXPECT_NE(words.find("the environment maps of 12000 mirrors with 1024 x 1024 texels need 906 GB"), std::string::npos)
      << words;
  EXPECT_NE(words.find("environment-size"), std::string::npos) << words;
  EXPECT_EQ(refusal(mirrors, 8, {"environment=room-map", "environment-size=64"}), "") << "one map for all";
}

TEST(PictureMemory, TrianglesAreCountedBeforeTheyAreMade) {
  if (could_be_held()) GTEST_SKIP() << "this computer could hold them";
  const std::string teapots = "model { name = t generator = teapot divisions = 1 }\n" +
                              repeated(3000, "instance { model = t position = (0,0,5) }\n");
  const std::string words = refusal(teapots, 2000, {"patches=projected-error", "tessellation=0.05"});
  EXPECT_NE(words.find("triangles of spheres and curved models need"), std::string::npos) << words;
  EXPECT_NE(words.find("tessellation"), std::string::npos) << words;
  const std::string balls = repeated(12000, "sphere { center=(0,0,2) radius=0.9 }\n");
  EXPECT_NE(refusal(balls, 8000, {"tessellation=0.05"}).find("set a larger 'tessellation'"), std::string::npos);
}

/// A view from the origin along +z at this size of picture.
raster::TessellationView looking_along_z(int size, double error, raster::FarSide far_side) {
  Viewport<double> viewport;
  viewport.columns = viewport.rows = size;
  viewport.span_x = viewport.span_y = size;
  raster::TessellationView view = raster::make_tessellation_view(Camera{}, viewport, 1, error);
  view.far_side = far_side;
  return view;
}

TEST(PictureMemory, CountsAreThoseOfTheMeshes) {
  for (const raster::FarSide far_side : {raster::FarSide::hidden, raster::FarSide::seen})
    for (const int size : {1, 60, 900})
      for (const double error : {0.05, 0.5, 8.0}) {
        const raster::TessellationView view = looking_along_z(size, error, far_side);
        for (const Sphere& sphere : {Sphere{{0, 0, 3}, 1, 0}, Sphere{{0, -5001, 0}, 5000, 0}, Sphere{{0, 0, 0}, 2, 0},
                                     Sphere{{1, 2, -9}, 1e-6, 0}})
          EXPECT_EQ(raster::sphere_triangles(sphere, view), raster::tessellate_sphere(sphere, view).triangles.size())
              << "radius " << sphere.radius << ", size " << size << ", error " << error;
        for (const Form& form :
             {Form(Ball{{0, 0, 3}, 1}), Form(Plane{{0, -1, 0}, {0, 1, 0}}),
              Form(Rectangle{{0, 0, 3}, {1, 0, 0}, {0, 1, 0}}), Form(Brick{{0, 0, 5}, {1, 1, 1}, Mat3d(1)}),
              Form(Cylinder{{0, 0, 4}, {0, 1, 4}, 0.5})})
          for (const Sides sides : {Sides::two, Sides::front}) {
            Solid solid;
            solid.form = form;
            solid.sides = sides;
            EXPECT_EQ(raster::solid_triangles(solid, view), raster::tessellate_solid(solid, view).triangles.size())
                << "form " << form.index() << ", size " << size << ", error " << error;
          }
      }
}

}  // namespace
}  // namespace ps::picture_memory_test
