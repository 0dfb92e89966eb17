// A camera inside glass, against Snell's law: along plane or concentric boundaries n sin is conserved.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "inspect/describe.h"
#include "render/story/story_tree.h"
#include "scene/scene_file.h"
#include "support/render_once.h"

namespace ps::eye_in_glass_test {
namespace {

PixelStory story_in_glass(const Scene& scene, const Settings& settings, Vec2i pixel) {
  return inspect(scene, View{scene.camera, 40, 30}, settings, pixel);
}

Settings near_settings(Precision precision) {
  Settings settings;
  settings.precision = precision;
  settings.near = 0.01;
  settings.reflection_depth = 8;
  return settings;
}

/// The rays of the story that run on through boundaries, eye ray first, as unit directions with where they begin.
std::vector<RayEvent> rays_through(const PixelStory& story) {
  std::vector<RayEvent> rays;
  for (const auto* ray : events_of<RayEvent>(story.events))
    if (ray->kind == RayKind::eye || ray->kind == RayKind::refraction) rays.push_back(*ray);
  return rays;
}

const std::string box_of_glass = "box { center=(0,0,0) size=(2,2,2) transparency=1 refraction_index=1.5 }";
const std::string mesh_of_glass = R"(model { name = m transparency = 1 refraction_index = 1.5
  vertices { 0=(-1,-1,-1) 1=(1,-1,-1) 2=(1,1,-1) 3=(-1,1,-1) 4=(-1,-1,1) 5=(1,-1,1) 6=(1,1,1) 7=(-1,1,1) }
  triangles { 0 = 0,3,2 1 = 0,2,1 2 = 4,5,6 3 = 4,6,7 4 = 0,1,5 5 = 0,5,4 6 = 3,7,6 7 = 3,6,2 8 = 0,4,7 9 = 0,7,3
  10 = 1,2,6 11 = 1,6,5 } }
  instance { model = m })";

TEST(EyeInGlass, ARayThatLeavesABoxIsBentBySnellsLaw) {
  for (const std::string& body : {box_of_glass, mesh_of_glass})
    for (const Accelerator accelerator : {Accelerator::bvh, Accelerator::two_level, Accelerator::none})
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        const Scene scene = parse_scene("background = black " + body, "glass.scene", ".");
        Settings settings = near_settings(precision);
        settings.accelerator = accelerator;
        for (const Vec2i pixel : {Vec2i{20, 15}, Vec2i{38, 15}, Vec2i{5, 3}}) {
          const PixelStory story = story_in_glass(scene, settings, pixel);
          const auto rays = rays_through(story);
          ASSERT_EQ(rays.size(), 2u) << body;
          const Vec3d inside = glm::normalize(rays[0].direction), outside = glm::normalize(rays[1].direction);
          EXPECT_NEAR(outside.x, 1.5 * inside.x, 1e-5);  // the boundary is perpendicular to z
          EXPECT_NEAR(outside.y, 1.5 * inside.y, 1e-5);
          ASSERT_EQ(rays[0].inside.size(), 1u);
          EXPECT_EQ(rays[0].inside[0].object, 0);
          EXPECT_NEAR(rays[0].inside[0].index, 1.5, 1e-6);
          EXPECT_NE(describe(story.events.front(), scene).find("origin inside"), std::string::npos)
              << describe(story.events.front(), scene);
        }
      }
}

// Where the eye stands in the inner of two balls, every boundary has its own two indices.
TEST(EyeInGlass, NestedBallsKeepTheirOrder) {
  for (const bool inner_first : {true, false}) {
    const std::string inner = "sphere { center=(0,0,0) radius=1 transparency=1 refraction_index=1.3 } ";
    const std::string outer = "sphere { center=(0,0,0) radius=3 transparency=1 refraction_index=1.7 } ";
    Scene scene =
        parse_scene("background = black " + (inner_first ? inner + outer : outer + inner), "balls.scene", ".");
    scene.camera.position = {0.3, -0.2, 0.1};
    const PixelStory story = story_in_glass(scene, near_settings(Precision::float64), {33, 9});
    const auto rays = rays_through(story);
    ASSERT_EQ(rays.size(), 3u);
    // n |r x d| is the same all the way (Bouguer): the boundaries are concentric.
    const auto invariant = [](const RayEvent& ray, double index) {
      return index * glm::length(cross(ray.origin, glm::normalize(ray.direction)));
    };
    const double wanted = invariant(rays[0], 1.3);
    EXPECT_GT(wanted, 0.1);
    EXPECT_NEAR(invariant(rays[1], 1.7), wanted, 1e-6);
    EXPECT_NEAR(invariant(rays[2], 1), wanted, 1e-6);
    ASSERT_EQ(rays[0].inside.size(), 2u);
    EXPECT_NEAR(rays[0].inside[0].index, 1.3, 1e-6);
    EXPECT_NEAR(rays[0].inside[1].index, 1.7, 1e-6);
  }
}

TEST(EyeInGlass, WhatLiesBeforeTheNearLimitIsNoMedium) {
  const Scene scene = parse_scene("background = black " + box_of_glass, "glass.scene", ".");
  Settings settings = near_settings(Precision::float32);
  settings.near = 3;
  EXPECT_TRUE(rays_through(story_in_glass(scene, settings, {20, 15}))[0].inside.empty());
}

TEST(EyeInGlass, AHollowIsNotInsideTheGlassAroundIt) {
  const Scene scene = parse_scene("background = black difference { " + box_of_glass +
                                      " sphere { center=(0,0,0) radius=0.5 transparency=1 refraction_index=1.5 } }",
                                  "hollow.scene", ".");
  const auto rays = rays_through(story_in_glass(scene, near_settings(Precision::float64), {38, 15}));
  ASSERT_EQ(rays.size(), 3u);
  EXPECT_TRUE(rays[0].inside.empty());
  // The hollow's wall is met at a right angle, the box's from within the glass.
  EXPECT_NEAR(glm::length(glm::normalize(rays[0].direction) - glm::normalize(rays[1].direction)), 0, 1e-9);
  EXPECT_NEAR(glm::normalize(rays[2].direction).x, 1.5 * glm::normalize(rays[1].direction).x, 1e-9);
}

// The picture is what the inspector says, pixel by pixel, on every path.
TEST(EyeInGlass, PicturesAgreeWithStories) {
  const Scene scene = parse_scene("background = black " + mesh_of_glass +
                                      " rectangle { corner=(-9,0,9) side_a=(0,9,0) side_b=(18,0,0) color=red }"
                                      " light { type = ambient intensity = 1 }",
                                  "glass.scene", ".");
  for (const Simd simd : {Simd::automatic, Simd::off}) {
    Settings settings = near_settings(Precision::float32);
    settings.simd = simd;
    const Frame frame = render(scene, View{scene.camera, 40, 30}, settings);
    int red = 0;
    for (int y = 1; y < 30; y += 7)
      for (int x = 1; x < 40; x += 9) {
        EXPECT_EQ(Vec3d(frame.colour.at(x, y)), story_in_glass(scene, settings, {x, y}).linear);
        red += frame.colour.at(x, y).x > 0.5f ? 1 : 0;
      }
    EXPECT_GT(red, 3);
  }
}

}  // namespace
}  // namespace ps::eye_in_glass_test
