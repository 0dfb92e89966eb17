#include "scene/edit.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "image/file.h"
#include "scene/load.h"
#include "scene/object_surface.h"
#include "scene/scene_file.h"
#include "scene/scene_text.h"
#include "scene/scene_writer.h"
#include "scene_random.h"
#include "support/refusal.h"
#include "support/run_cli.h"

namespace scene_edit_test {
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

TEST(SceneEdit, ATextureIsPutOnOneObjectAlone) {
  const ps::test::ScratchFolder scratch;
  ps::Image<ps::Rgb8> picture(2, 1);
  picture.at(1, 0) = {255, 128, 0};
  const std::string file = scratch.file("a \"quoted\" name.png");
  ps::save_image(file, picture);
  // Two balls with one material, and one with its own.
  ps::Scene scene = ps::parse_scene("material { name = red color = red }\n"
                                    "sphere { center = (0, 0, 5) radius = 1 material = red }\n"
                                    "sphere { center = (3, 0, 5) radius = 1 material = red }\n"
                                    "sphere { center = (6, 0, 5) radius = 1 color = blue }\n",
                                    "balls.scene", scratch.path());
  const ps::Scene before = scene;
  for (const std::size_t object : {0u, 2u}) {
    const std::string name = "object." + std::to_string(object);
    ps::set_property(scene, name + ".texture", ps::scene_name(file));
    ps::set_property(scene, name + ".color", "white");
    const ps::Material& material = ps::material_of(scene, static_cast<int>(object), 0);
    EXPECT_EQ(material.colour, ps::Vec3d(1, 1, 1));
    EXPECT_EQ(scene.textures->at(static_cast<std::size_t>(material.texture)).texels->at(1, 0).r, 1.f);
    EXPECT_EQ(ps::get_property(scene, name + ".texture"), ps::scene_name(file));
  }
  EXPECT_EQ(ps::material_of(scene, 1, 0), ps::material_of(before, 1, 0)) << "it shared the first one's material";
  EXPECT_EQ(scene.textures->size(), 1u) << "the same file for both";
  EXPECT_EQ(scene.materials->size(), before.materials->size() + 1) << "the third ball's was its own already";
  // What is saved is what was seen.
  const ps::Scene again = ps::parse_scene(ps::write_scene(scene, scratch.path()), "saved.scene", scratch.path());
  for (int object = 0; object < 3; ++object) {
    const ps::Material &a = ps::material_of(scene, object, 0), &b = ps::material_of(again, object, 0);
    EXPECT_EQ(a.colour, b.colour);
    EXPECT_EQ(ps::texture_text(scene, a.texture), ps::texture_text(again, b.texture));
  }
  const auto revision = scene.materials.revision();
  EXPECT_THROW(ps::set_property(scene, "object.1.texture", "nowhere.png"), ps::InputError);
  EXPECT_EQ(scene.materials.revision(), revision);
  ps::set_property(scene, "object.0.texture", "none");
  EXPECT_EQ(ps::material_of(scene, 0, 0).texture, -1);
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
  EXPECT_NE(
      ps::test::refusal_of([&] { ps::set_property(scene, "object.0.centre", "(0, 0, 0)"); }).find("'object.0.center'"),
      std::string::npos);
}

}  // namespace
}  // namespace scene_edit_test
