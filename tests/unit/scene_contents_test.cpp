// Objects and lights that are put into a scene and taken out of it, and kept by links and files.
#include "scene/contents.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/check.h"
#include "document/document.h"
#include "document/permalink.h"
#include "obj_corpus.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/object_boxes.h"
#include "scene/scene_writer.h"
#include "support/render_once.h"
#include "support/same_bits.h"

namespace ps::scene_contents_test {
namespace {

Image<Vec3f> picture_of(const Scene& scene, Renderer renderer, const Settings& like = {}) {
  Settings settings = like;
  settings.renderer = renderer;
  View view = view_of(scene, {}, 48, 48);
  return render(scene, view, settings, request_for(Channel::none)).colour;
}

bool same_picture(const Scene& a, const Scene& b) {
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer})
    if (!test::same_bits(picture_of(a, renderer), picture_of(b, renderer))) return false;
  return true;
}

/// A copy in the place of its original changes the order alone, which decides ties alone.
TEST(SceneContents, ACopyInTheOriginalsPlaceLooksTheSame) {
  for (const char* name : {"cgfs/reflections", "cgfs/crates", "cgfs/wireframe"}) {
    const Scene before = load_scene(name);
    for (std::size_t i = 0; i < before.geometry->objects.size(); ++i) {
      SCOPED_TRACE(fmt::format("{} {}", name, i));
      Scene scene = before;
      change_contents(scene, "object.copy", std::to_string(i));
      ASSERT_EQ(scene.geometry->objects.size(), before.geometry->objects.size() + 1);
      change_contents(scene, "object.remove", std::to_string(i));
      EXPECT_TRUE(same_picture(scene, before));
      change_contents(scene, "object.remove", std::to_string(before.geometry->objects.size() - 1));
      EXPECT_FALSE(same_picture(scene, before)) << "the comparison must be able to fail";
    }
  }
}

TEST(SceneContents, ACopyOfAnyShapeLiesWhereItIsPut) {
  const Vec3d by{0.5, -2, 4};
  std::size_t shapes = 0;
  for (const auto& listed : builtin_scenes()) {
    const Scene before = load_scene(listed.name);
    for (std::size_t i = 0; i < std::min<std::size_t>(before.geometry->objects.size(), 4); ++i) {
      Scene scene = before;
      change_contents(scene, "object.copy", fmt::format("{} + (0.5, -2, 4)", i));
      const auto boxes = boxes_of_objects(*scene.geometry);
      for (int axis = 0; axis < 3; ++axis) {
        const double low = boxes[i].low[axis] + by[axis], high = boxes[i].high[axis] + by[axis];
        if (!std::isfinite(low) || !std::isfinite(high)) continue;
        const double scale = 1 + std::abs(low) + std::abs(high);
        EXPECT_NEAR(boxes.back().low[axis], low, 1e-9 * scale) << listed.name << ' ' << i;
        EXPECT_NEAR(boxes.back().high[axis], high, 1e-9 * scale) << listed.name << ' ' << i;
      }
      EXPECT_NE(scene.geometry->objects.back().name, before.geometry->objects[i].name) << "names are unique";
      shapes |= std::size_t{1} << before.geometry->objects[i].shape.index();
    }
  }
  EXPECT_EQ(shapes, 15u) << "spheres, models, solids and CSG";
}

/// A scene in which things were added, copied and removed between changes of properties.
Document changed_document(const std::string& name) {
  Document document = open_document(name, load_scene(name));
  for (const SceneEdit& edit : {SceneEdit{"object.0.center", "(0.5, -1, 3)"}, SceneEdit{"object.copy", "0 + (0, 1, 0)"},
                                SceneEdit{"object.0.center", "(-2, 0, 4)"}, SceneEdit{"object.remove", "1"},
                                SceneEdit{"object.1.radius", "0.75"}, SceneEdit{"object.add", "box"},
                                SceneEdit{"object.4.center", "(-1, 0.5, 3)"},
                                SceneEdit{"object.4.color", "(10, 200, 30)"}, SceneEdit{"object.add", "sphere"},
                                SceneEdit{"object.5.center", "(1, 1, 3.5)"}, SceneEdit{"light.copy", "1 + (0, 2, 0)"},
                                SceneEdit{"light.remove", "0"}, SceneEdit{"light.0.intensity", "0.25"},
                                SceneEdit{"light.add", "directional"}, SceneEdit{"light.3.direction", "(1, 1, -1)"}})
    edit_scene(document, edit);
  return document;
}

TEST(SceneContents, EditsMeanWhatTheyMeantWhenTheyWereMade) {
  const Document document = changed_document("cgfs/reflections");
  const auto& objects = document.scene.geometry->objects;
  ASSERT_EQ(objects.size(), 6u) << "of 4 one is gone, one is a copy and two are new";
  EXPECT_EQ(std::get<Sphere>(objects[0].shape).centre, Vec3d(-2, 0, 4));
  EXPECT_EQ(std::get<Sphere>(objects[1].shape).radius, 0.75) << "object 2 of the file";
  EXPECT_EQ(std::get<Sphere>(objects[3].shape).centre, Vec3d(0.5, 0, 3)) << "of the place before the second move";
  EXPECT_EQ(std::get<Brick>(std::get<Solid>(objects[4].shape).form).centre, Vec3d(-1, 0.5, 3));
  const auto& lights = *document.scene.lights;
  ASSERT_EQ(lights.size(), 4u);
  EXPECT_EQ(lights[0].kind, LightKind::point) << "the ambient one is gone";
  EXPECT_EQ(lights[0].intensity, 0.25);
  EXPECT_EQ(lights[2].position, lights[0].position + Vec3d(0, 2, 0));
  EXPECT_EQ(lights[3].direction, Vec3d(1, 1, -1));
  EXPECT_EQ(document.edits.size(), 15u) << "none takes another's place across these";
  Document again = document;
  edit_scene(again, {"light.3.direction", "(0, 1, 0)"});
  EXPECT_EQ(again.edits.size(), 15u) << "but one after them does";
}

TEST(SceneContents, LinksAndSavedScenesShowTheSamePicture) {
  const Document document = changed_document("cgfs/reflections");
  EXPECT_FALSE(same_picture(document.scene, document.base));
  Document linked = parse_permalink(permalink(document));
  attach_scene(linked, load_scene(linked.scene_name));
  EXPECT_EQ(linked.edits, document.edits);
  EXPECT_TRUE(same_picture(linked.scene, document.scene));
  const test::ModelFolder folder;
  const auto path = folder.path() / "saved.scene";
  save_scene(document.scene, path);
  EXPECT_TRUE(same_picture(load_scene(path.string()), document.scene));
}

TEST(SceneContents, AllCanBeTakenOut) {
  Scene scene = load_scene("cgfs/reflections");
  while (!scene.geometry->objects.empty()) change_contents(scene, "object.remove", "0");
  while (!scene.lights->empty()) change_contents(scene, "light.remove", "0");
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer})
    EXPECT_EQ(picture_of(scene, renderer).at(5, 5), Vec3f(scene.background));
  const test::ModelFolder folder;
  save_scene(scene, folder.path() / "saved.scene");
  EXPECT_TRUE(load_scene((folder.path() / "saved.scene").string()).geometry->objects.empty());
}

TEST(SceneContents, WhatDoesNotFitIsRefusedAndChangesNothing) {
  const Document before = open_document("cgfs/reflections", load_scene("cgfs/reflections"));
  for (const SceneEdit& edit :
       {SceneEdit{"object.remove", "4"}, SceneEdit{"object.remove", "-1"}, SceneEdit{"object.remove", "0 + (1, 0, 0)"},
        SceneEdit{"object.copy", "0 +"}, SceneEdit{"object.copy", "0 + (1, 2)"}, SceneEdit{"object.copy", ""},
        SceneEdit{"object.copy", "99999999999999999999"}, SceneEdit{"object.add", "teapot"},
        SceneEdit{"light.add", "spot"}, SceneEdit{"light.copy", "3"}, SceneEdit{"light.remove", "x"}}) {
    Document document = before;
    EXPECT_THROW(edit_scene(document, edit), InputError) << edit.path << '=' << edit.value;
    EXPECT_TRUE(document == before);
  }
  EXPECT_FALSE(changes_contents("object.0.copy"));
  EXPECT_FALSE(changes_contents("object.added"));
}

}  // namespace
}  // namespace ps::scene_contents_test
