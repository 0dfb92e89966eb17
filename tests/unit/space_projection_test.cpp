// The view from outside: where its cameras stand, and that lines drawn over its picture meet what it shows.
#include "inspect/space_projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "inspect/space_orbit.h"
#include "raster/renderer.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::space_projection_test {
namespace {

constexpr std::array presets{SpacePreset::outside, SpacePreset::front, SpacePreset::side, SpacePreset::top};

TEST(SpaceOrbit, EveryPresetAimsAtTheMiddleAndShowsAll) {
  const SpaceBounds bounds{{1, 2, 3}, 4, {{{1, 2, 3}, 0.5}, {{-2, 2, 3}, 0}, {{1, 4, 5}, 1}}};
  for (const SpacePreset preset : presets)
    for (const double aspect : {0.5, 1.0, 3.0}) {
      const int width = static_cast<int>(400 * aspect), height = 400;
      const SpaceOrbit orbit = preset_orbit(preset, bounds, Camera{}, aspect);
      const View view = orbit_view(orbit, Camera{}, width, height);
      const SpaceProjection projection(view, Settings{}, 0.01);
      const auto middle = projection.point(bounds.centre);
      ASSERT_TRUE(middle);
      EXPECT_NEAR(middle->at.x, width / 2.0, 1e-9);
      EXPECT_NEAR(middle->at.y, height / 2.0, 1e-9);
      EXPECT_NEAR(middle->z, orbit.distance, 1e-12);
      // Points of every part's surface are in the picture.
      for (const SpaceBall& part : bounds.parts)
        for (const Vec3d& way :
             {Vec3d(1, 0, 0), Vec3d(-1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, -1, 0), Vec3d(0, 0, 1), Vec3d(0, 0, -1)}) {
          const auto place = projection.point(part.centre + way * part.radius);
          ASSERT_TRUE(place);
          EXPECT_GT(place->at.x, 0);
          EXPECT_LT(place->at.x, width);
          EXPECT_GT(place->at.y, 0);
          EXPECT_LT(place->at.y, height);
        }
    }
}

TEST(SpaceOrbit, AxesAreRightAngledAndKeepTheirHandedness) {
  Camera slanted;  // LAB: y down
  slanted.up = {0.1, -1, 0.2};
  slanted.forward = {0, 0.1, 2};
  const double sense = dot(slanted.right, cross(slanted.up, slanted.forward));
  for (const SpacePreset preset : presets) {
    const Camera c = orbit_view(preset_orbit(preset, {}, slanted, 1), slanted, 100, 100).camera;
    EXPECT_NEAR(dot(c.right, c.up), 0, 1e-12);
    EXPECT_NEAR(dot(c.right, c.forward), 0, 1e-12);
    EXPECT_NEAR(dot(c.up, c.forward), 0, 1e-12);
    EXPECT_NEAR(glm::length(c.forward), 1, 1e-12);
    EXPECT_GT(dot(c.right, cross(c.up, c.forward)) * sense, 0);
  }
}

// From its right the camera looks from left to right; from above likewise.
TEST(SpaceOrbit, SideAndTopHaveTheCameraAtTheLeft) {
  for (const SpacePreset preset : {SpacePreset::side, SpacePreset::top}) {
    const View view =
        orbit_view(preset_orbit(preset, {{0, 0, 0}, 1, {{{0, 0, 0}, 1}}}, Camera{}, 1), Camera{}, 100, 100);
    const SpaceProjection projection(view, Settings{}, 0.01);
    EXPECT_GT(projection.point({0, 0, 0.5})->at.x, 55);
    EXPECT_NEAR(projection.point({0, 0, 0.5})->at.y, 50, 1e-9);
  }
  const View top =
      orbit_view(preset_orbit(SpacePreset::top, {{0, 0, 0}, 1, {{{0, 0, 0}, 1}}}, Camera{}, 1), Camera{}, 100, 100);
  EXPECT_NEAR(top.camera.forward.y, -1, 1e-12);
}

TEST(SpaceOrbit, ThroughTheCameraIsThePictureWithAMargin) {
  const Scene scene = load_scene("cgfs/reflections");
  const View picture{scene.camera, 600, 600};
  const View view = through_camera(picture, Settings{}, 1.25, 1000, 500);
  const SpaceProjection projection(view, Settings{}, 0.01);
  // The image's top edge is at y = 1/2 on z = 1: a tenth of the height below the view's own.
  EXPECT_NEAR(projection.point({0, 0.5, 1})->at.y, 50, 1e-9);
  EXPECT_NEAR(projection.point({0.5, 0, 1})->at.x, 700, 1e-9);
}

// The rasterizer's own picture says what is seen where the projection puts a sphere's centre.
TEST(SpaceProjection, AgreesWithTheRasterizersPicture) {
  const Scene scene = load_scene("cgfs/spheres");
  SpaceOrbit orbit = preset_orbit(SpacePreset::top, {{0, 0, 3}, 4, {{{0, 0, 3}, 4}}}, scene.camera, 1);
  int seen = 0;
  for (const double pitch : {1.0, 1.4, std::numbers::pi / 2}) {
    orbit.pitch = pitch;
    const View view = orbit_view(orbit, scene.camera, 200, 200);
    Settings settings{.renderer = Renderer::rasterizer};
    settings.near = 0.01;
    Prepared prepared;
    Progress progress;
    const Frame frame =
        render_rasterized(scene, view, settings, request_for(Channel::ids | Channel::depth), prepared, progress);
    const SpaceProjection projection(view, settings, 0.01);
    for (const Vec2i& at : {Vec2i(0, 0), Vec2i(1, 0), Vec2i(2, 0)}) {
      const auto& sphere = std::get<Sphere>(scene.geometry->objects[static_cast<std::size_t>(at.x)].shape);
      const auto place = projection.point(sphere.centre);
      ASSERT_TRUE(place);
      const Vec2i pixel(place->at);
      if (frame.ids.at(pixel.x, pixel.y).object != at.x) continue;  // another one is in front
      ++seen;
      EXPECT_TRUE(is_hidden(frame.depth, *place));
      const Vec3d to_viewer = glm::normalize(view.camera.position - sphere.centre);
      const auto top = projection.point(sphere.centre + to_viewer * sphere.radius);
      EXPECT_FALSE(is_hidden(frame.depth, *top));
      EXPECT_NEAR(static_cast<double>(frame.depth.at(pixel.x, pixel.y)), top->z, 0.02);
    }
  }
  EXPECT_GT(seen, 5) << "from above spheres seldom hide each other";
}

// A wall at depth 2.5 fills the left half of the picture; the line goes from depth 2 in the left to depth 8 in the
// right.
TEST(SpaceProjection, LinesAreDividedWhereTheyPassBehind) {
  Image<float> depth(100, 100, std::numeric_limits<float>::infinity());
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 50; ++x) depth.at(x, y) = 2.5f;
  const SpaceRun line{{{0, 50}, 2}, {{100, 50}, 8}, false};
  const auto runs = visible_runs(depth, line);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_FALSE(runs[0].hidden);
  EXPECT_TRUE(runs[1].hidden);
  EXPECT_FALSE(runs[2].hidden);
  EXPECT_NEAR(runs[1].from.at.x, 100 * (1 / 2.0 - 1 / 2.5) / (1 / 2.0 - 1 / 8.0), 4);
  EXPECT_NEAR(runs[1].to.at.x, 50, 3);
  EXPECT_NEAR(runs[0].from.at.x, 0, 1e-9);
  EXPECT_NEAR(runs[2].to.at.x, 100, 1e-9);
}

// 1/z is linear on the picture: depth 4 between 2 and 8 lies at 2/3 of the way, not at 1/3.
TEST(SpaceProjection, DepthAlongALineIsPerspective) {
  const Image<float> wall(300, 1, 4.0f);
  const auto runs = visible_runs(wall, {{{0, 0.5}, 2}, {{300, 0.5}, 8}, false});
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_NEAR(runs[0].to.at.x, 200, 8);
}

TEST(SpaceProjection, LinesAreCutAtTheNearPlane) {
  const View view{Camera{}, 100, 100};
  const SpaceProjection projection(view, Settings{}, 0.5);
  EXPECT_FALSE(projection.line({0, 0, -1}, {1, 0, 0.4}));
  EXPECT_FALSE(projection.point({0, 0, 0.4}));
  const auto line = projection.line({0, 0, -1}, {0, 0, 2});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->from.z, 0.5, 1e-12);
  EXPECT_NEAR(line->to.z, 2, 1e-12);
  EXPECT_TRUE(projection.polygon({{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}).empty());
  EXPECT_EQ(projection.polygon({{0, 0, 1}, {1, 0, 1}, {0, 1, -1}}).size(), 4u);
}

}  // namespace
}  // namespace ps::space_projection_test
