#include "scene/edit.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "scene/load.h"
#include "scene_random.h"

namespace {

TEST(SceneEdit, MovesALightAndTouchesNothingElse) {
  const ps::Scene before = ps::load_scene("cgfs/reflections");
  ps::Scene scene = before;
  ps::set_property(scene, "light.1.position", "(2, 1.5, -0.25)");
  EXPECT_EQ(scene.lights->at(1).position, ps::Vec3d(2, 1.5, -0.25));
  EXPECT_EQ(before.lights->at(1).position, ps::Vec3d(2, 1, 0));
  EXPECT_NE(scene.lights.revision(), before.lights.revision());
  EXPECT_EQ(scene.geometry.revision(), before.geometry.revision());
  EXPECT_EQ(scene.materials.revision(), before.materials.revision());
  EXPECT_EQ(scene.textures.revision(), before.textures.revision());
}

TEST(SceneEdit, EveryPropertyReadsBackItsOwnValue) {
  for (const char* name : {"cgfs/reflections", "cgfs/shading", "cgfs/camera", "models/dice"}) {
    const ps::Scene before = ps::load_scene(name);
    for (const ps::SceneProperty& property : ps::scene_properties(before)) {
      SCOPED_TRACE(property.path);
      ps::Scene scene = before;
      EXPECT_EQ(ps::get_property(scene, property.path), property.value);
      ps::set_property(scene, property.path, property.value);
      ps::test::expect_equal_scenes(scene, before);
    }
  }
}

TEST(SceneEdit, ValuesOfEveryKind) {
  ps::Scene scene = ps::load_scene("cgfs/shading");
  ps::set_property(scene, "object.2.translation", "(1, 2, 3)");
  ps::set_property(scene, "object.0.rotation", "<90 degrees around the Y axis>");
  ps::set_property(scene, "material.0.specular", "-1");
  ps::set_property(scene, "background", "black");
  ps::set_property(scene, "camera.position", "(0, 0, -3)");
  EXPECT_EQ(ps::get_property(scene, "object.2.translation"), "(1, 2, 3)");
  EXPECT_EQ(ps::get_property(scene, "object.0.rotation"), "<90 degrees around the Y axis>");
  EXPECT_FALSE(scene.materials->at(0).specular);
  EXPECT_EQ(scene.background, ps::Vec3d(0, 0, 0));
  EXPECT_EQ(scene.camera.position, ps::Vec3d(0, 0, -3));
}

TEST(SceneEdit, WrongPathsAndValuesAreRefusedAndChangeNothing) {
  const ps::Scene before = ps::load_scene("cgfs/reflections");
  ps::Scene scene = before;
  for (const char* path :
       {"", "light", "light.0.position", "light.3.intensity", "light.x.intensity", "light.-1.intensity",
        "object.0.translation", "object.99999999999999999999.center", "camera.zoom"})
    EXPECT_THROW(ps::set_property(scene, path, "1"), ps::InputError) << path;
  EXPECT_THROW(ps::set_property(scene, "object.0.radius", "-1"), ps::InputError);
  EXPECT_THROW(ps::set_property(scene, "object.0.radius", "1 sphere { }"), ps::InputError);
  EXPECT_THROW(ps::set_property(scene, "light.1.position", "(nan, 0, 0)"), ps::InputError);
  EXPECT_THROW(ps::set_property(scene, "light.2.direction", "(0, 0, 0)"), ps::InputError);
  ps::test::expect_equal_scenes(scene, before);
  EXPECT_EQ(scene.lights.revision(), before.lights.revision());
  EXPECT_EQ(scene.geometry.revision(), before.geometry.revision());
}

TEST(SceneEdit, AWrongNameSuggestsTheNearest) {
  ps::Scene scene = ps::load_scene("cgfs/reflections");
  try {
    ps::set_property(scene, "object.0.centre", "(0, 0, 0)");
    FAIL();
  } catch (const ps::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'object.0.center'"), std::string::npos) << error.what();
  }
}

}  // namespace
