#include "scene/load.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "support/refusal.h"

namespace scene_load_test {
namespace {

// The numbers of the book's own program for this picture.
TEST(SceneLoad, ReflectionsHasTheBooksNumbers) {
  const ps::Scene scene = ps::load_scene("cgfs/reflections");
  EXPECT_EQ(scene.name, "cgfs/reflections");
  EXPECT_EQ(scene.canvas_width, 600);
  EXPECT_EQ(scene.canvas_height, 600);
  EXPECT_EQ(scene.camera, ps::Camera{});
  EXPECT_EQ(scene.background, ps::Vec3d(0, 0, 0));
  struct Expected {
    const char* name;
    ps::Vec3d centre;
    double radius;
    ps::Vec3d colour;
    double specular, reflective;
  };
  const Expected expected[] = {{"red", {0, -1, 3}, 1, {1, 0, 0}, 500, 0.2},
                               {"green", {-2, 0, 4}, 1, {0, 1, 0}, 10, 0.4},
                               {"blue", {2, 0, 4}, 1, {0, 0, 1}, 500, 0.3},
                               {"ground", {0, -5001, 0}, 5000, {1, 1, 0}, 1000, 0.5}};
  ASSERT_EQ(scene.geometry->objects.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const ps::Object& object = scene.geometry->objects[i];
    EXPECT_EQ(object.name, expected[i].name);
    const auto& sphere = std::get<ps::Sphere>(object.shape);
    EXPECT_EQ(sphere.centre, expected[i].centre);
    EXPECT_EQ(sphere.radius, expected[i].radius);
    const ps::Material& material = ps::material_of(scene, static_cast<int>(i), 0);
    EXPECT_EQ(material.colour, expected[i].colour);
    EXPECT_EQ(material.specular, expected[i].specular);
    EXPECT_EQ(material.reflective, expected[i].reflective);
  }
  const auto& lights = *scene.lights;
  ASSERT_EQ(lights.size(), 3U);
  EXPECT_EQ(lights[0].kind, ps::LightKind::ambient);
  EXPECT_EQ(lights[0].intensity, 0.2);
  EXPECT_EQ(lights[1].kind, ps::LightKind::point);
  EXPECT_EQ(lights[1].intensity, 0.6);
  EXPECT_EQ(lights[1].position, ps::Vec3d(2, 1, 0));
  EXPECT_EQ(lights[2].kind, ps::LightKind::directional);
  EXPECT_EQ(lights[2].intensity, 0.2);
  EXPECT_EQ(lights[2].direction, ps::Vec3d(1, 4, 4));
}

TEST(SceneLoad, EveryBuiltInSceneLoads) {
  const auto& scenes = ps::builtin_scenes();
  ASSERT_FALSE(scenes.empty());
  for (const auto& listed : scenes) {
    SCOPED_TRACE(listed.name);
    const ps::Scene scene = ps::load_scene(listed.name);
    EXPECT_EQ(scene.title, listed.title);
    EXPECT_EQ(scene.description, listed.description);
    EXPECT_FALSE(scene.description.empty());
    EXPECT_GE(scene.start_pixel.x, 0);
    EXPECT_LT(scene.start_pixel.x, scene.canvas_width);
    EXPECT_LT(scene.start_pixel.y, scene.canvas_height);
    ASSERT_FALSE(ps::files_of(scene).empty());
  }
}

TEST(SceneLoad, AnUnknownNameSuggestsTheNearest) {
  EXPECT_NE(ps::test::refusal_of([&] { ps::load_scene("cgfs/reflexions"); }).find("'cgfs/reflections'"),
            std::string::npos);
}

TEST(SceneLoad, AFolderIsNoScene) { EXPECT_THROW(ps::load_scene("assets"), ps::InputError); }

}  // namespace
}  // namespace scene_load_test
