#include "document/document.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "document/history.h"
#include "document/number_list.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/share_content.h"
#include "support/refusal.h"
#include "support/stories.h"

namespace ps::document_test {
namespace {

TEST(Document, OpensAsTheSceneAsks) {
  Scene scene = test::book_spheres();
  scene.settings = {{"reflection-depth", "1"}, {"self-hit", "epsilon"}};
  scene.start_pixel = {5, 6};
  scene.canvas_width = 40;
  const Document document = open_document("test/spheres", scene);
  EXPECT_EQ(document.a.settings.reflection_depth, 1);
  EXPECT_EQ(document.b.settings.self_hit, SelfHit::epsilon);
  EXPECT_EQ(document.a.settings.renderer, Renderer::ray_tracer);
  EXPECT_EQ(document.b.settings.renderer, Renderer::rasterizer);
  EXPECT_EQ(document.pixel, Vec2i(5, 6));
  EXPECT_EQ(view_of(document).width, 40);
  EXPECT_EQ(view_of(document).height, 600);
}

TEST(Document, BothSidesTakeTheRendererThatTheSceneNames) {
  Scene scene = test::book_spheres();
  scene.settings = {{"renderer", "rasterizer"}};
  const Document document = open_document("test/spheres", scene);
  EXPECT_EQ(document.a.settings.renderer, Renderer::rasterizer);
  EXPECT_EQ(document.b.settings.renderer, Renderer::rasterizer);
}

TEST(Document, CopiesShareTheScene) {
  const Document document = open_document("x", test::book_spheres());
  const Document copy = document;
  EXPECT_EQ(&*copy.scene.geometry, &*document.scene.geometry);
  EXPECT_TRUE(copy == document);
}

TEST(Document, CameraAndSizeOverrideTheScene) {
  Document document = open_document("x", test::book_spheres());
  Camera camera;
  camera.position = {1, 2, 3};
  document.view.camera = camera;
  document.view.width = 8;
  document.view.height = 9;
  EXPECT_EQ(view_of(document), (View{camera, 8, 9}));
}

TEST(Document, EditsReplaceEarlierOnesOfTheSamePath) {
  Document document = open_document("x", test::book_spheres());
  edit_scene(document, {"light.1.intensity", "0.25"});
  edit_scene(document, {"light.2.intensity", "0.125"});
  edit_scene(document, {"light.1.intensity", "0.75"});
  EXPECT_EQ((*document.scene.lights)[1].intensity, 0.75);
  EXPECT_EQ((*document.scene.lights)[2].intensity, 0.125);
  EXPECT_EQ((*document.base.lights)[1].intensity, 0.5);
  EXPECT_EQ(document.edits.size(), 2u);
  EXPECT_EQ(document.scene.geometry.revision(), document.base.geometry.revision());
}

TEST(Document, AnEditThatDoesNotFitChangesNothing) {
  Document document = open_document("x", test::book_spheres());
  EXPECT_THROW(edit_scene(document, {"light.9.intensity", "1"}), InputError);
  EXPECT_THROW(edit_scene(document, {"light.1.intensity", "bright"}), InputError);
  EXPECT_TRUE(document.edits.empty());
  EXPECT_EQ((*document.scene.lights)[1].intensity, 0.5);
}

TEST(Document, AttachingASceneAppliesTheEdits) {
  Document document;
  document.edits = {{"light.1.intensity", "0.25"}};
  attach_scene(document, test::book_spheres());
  EXPECT_EQ((*document.scene.lights)[1].intensity, 0.25);
  EXPECT_EQ((*document.base.lights)[1].intensity, 0.5);
}

TEST(SceneSettings, UnknownOnesNameTheScene) {
  Scene scene = test::book_spheres();
  scene.settings = {{"reflection-dept", "1"}};
  EXPECT_EQ(test::refusal_of([&] { settings_for(scene); }),
            "scene test/spheres: found unknown key 'reflection-dept' in settings, expected 'reflection-depth'");
}

TEST(SceneSettings, DifferenceTurnsOneIntoTheOther) {
  Settings from, to;
  from.reflection_depth = 1;
  to.shadow_epsilon = 0.1;
  Settings result = from;
  const auto assignments = settings_difference(from, to);
  EXPECT_EQ(assignments, (std::vector<std::string>{"shadow-epsilon=0.1", "reflection-depth=3"}));
  for (const std::string& assignment : assignments) parse_assignment(assignment, result);
  EXPECT_EQ(result, to);
}

Document with_depth(const Document& document, int depth) {
  Document changed = document;
  changed.a.settings.reflection_depth = depth;
  return changed;
}

TEST(History, UndoAndRedoRestoreEverything) {
  const Document start = open_document("x", test::book_spheres());
  History history(start);
  history.push(with_depth(start, 1), "depth 1");
  history.push(with_depth(start, 2), "depth 2");
  history.undo();
  EXPECT_EQ(history.current().a.settings.reflection_depth, 1);
  history.undo();
  EXPECT_TRUE(history.current() == start);
  EXPECT_FALSE(history.can_undo());
  history.undo();
  EXPECT_TRUE(history.current() == start);
  history.redo();
  history.redo();
  EXPECT_EQ(history.current().a.settings.reflection_depth, 2);
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.entries()[1].label, "depth 1");
}

TEST(History, PushDropsWhatCouldBeRedone) {
  const Document start = open_document("x", test::book_spheres());
  History history(start);
  history.push(with_depth(start, 1), "1");
  history.undo();
  history.push(with_depth(start, 7), "7");
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.entries().size(), 2u);
}

/// A scene with a mesh of so many vertices.
Scene scene_with_vertices(std::size_t count) {
  Scene scene;
  Mesh mesh;
  mesh.positions.resize(count, Vec3d(0.5));
  Geometry geometry;
  geometry.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
  scene.geometry = Part(std::move(geometry));
  return scene;
}

TEST(History, ForgetsTheOldestWhereTheirMeshesTakeTooMuch) {
  constexpr std::size_t vertices = 1000, bytes = vertices * sizeof(Vec3d);
  History history(open_document("0", scene_with_vertices(vertices)), "0", 3 * bytes + bytes / 2);
  for (int i = 1; i < 8; ++i)
    history.push(open_document(std::to_string(i), scene_with_vertices(vertices)), std::to_string(i));
  ASSERT_EQ(history.entries().size(), 3u);
  EXPECT_EQ(history.entries().front().label, "5");
  EXPECT_EQ(history.current().scene_name, "7");
  // What shares the mesh costs nothing.
  for (int depth = 4; depth < 24; ++depth) history.push(with_depth(history.current(), depth), "depth");
  EXPECT_EQ(history.entries().size(), 23u);
  // The current one stays however large it is.
  history.push(open_document("large", scene_with_vertices(9 * vertices)), "large");
  EXPECT_EQ(history.entries().size(), 1u);
  EXPECT_FALSE(history.can_undo());
}

TEST(ShareContent, HoldsTheSameBytesOnce) {
  const Scene first = scene_with_vertices(10);
  const Scene same = share_content(scene_with_vertices(10), first);
  EXPECT_EQ(same.geometry->meshes[0], first.geometry->meshes[0]);
  const Scene other = share_content(scene_with_vertices(11), first);
  EXPECT_NE(other.geometry->meshes[0], first.geometry->meshes[0]);
  EXPECT_EQ(other.geometry->meshes[0]->positions.size(), 11u);
  EXPECT_TRUE(share_content(Scene{}, first).geometry->meshes.empty());
}

TEST(History, NothingNewIsNoEntry) {
  const Document start = open_document("x", test::book_spheres());
  History history(start);
  history.push(start, "again");
  EXPECT_EQ(history.entries().size(), 1u);
}

TEST(History, ADragIsOneEntry) {
  const Document start = open_document("x", test::book_spheres());
  History history(start);
  for (int depth = 4; depth < 20; ++depth) history.push(with_depth(start, depth), "drag", "slider");
  EXPECT_EQ(history.entries().size(), 2u);
  history.end_drag();
  history.push(with_depth(start, 30), "drag", "slider");
  EXPECT_EQ(history.entries().size(), 3u);
  history.undo();
  history.push(with_depth(start, 31), "drag", "slider");
  history.undo();
  EXPECT_EQ(history.current().a.settings.reflection_depth, 19);
}

TEST(History, ACancelledDragLeavesNothing) {
  const Document start = open_document("x", test::book_spheres());
  History history(start);
  history.push(with_depth(start, 7), "before");
  for (int depth = 10; depth < 14; ++depth) history.push(with_depth(start, depth), "drag", "slider");
  EXPECT_FALSE(history.cancel_drag("another"));
  EXPECT_TRUE(history.cancel_drag("slider"));
  EXPECT_EQ(history.current().a.settings.reflection_depth, 7);
  EXPECT_EQ(history.entries().size(), 2u);
  EXPECT_FALSE(history.can_redo());
  EXPECT_FALSE(history.cancel_drag("slider")) << "once";
  history.push(with_depth(start, 20), "drag", "slider");
  history.end_drag();
  EXPECT_FALSE(history.cancel_drag("slider")) << "it has ended";
  EXPECT_EQ(history.current().a.settings.reflection_depth, 20);
}

TEST(NumberList, ReadsSizesPixelsAndCameras) {
  EXPECT_EQ(parse_size_text("640x480"), Vec2i(640, 480));
  for (const char* bad : {"", "640", "640x", "x480", "0x0", "100000x100000", "-1x5", "1x5 ", "1.5x2", "99999999999x1"})
    EXPECT_THROW(parse_size_text(bad), InputError) << bad;
  EXPECT_EQ(parse_pixel_text("3,4"), Vec2i(3, 4));
  for (const char* bad : {"", "3", "3,", "-1,2", "3,4,5", "a,b"})
    EXPECT_THROW(parse_pixel_text(bad), InputError) << bad;
  Camera camera;
  camera.position = {0.1, 1.0 / 3, -2e-7};
  EXPECT_EQ(parse_camera_text(camera_text(camera)), camera);
  EXPECT_THROW(parse_camera_text("1,2,3"), InputError);
  EXPECT_THROW(parse_camera_text("0,0,0,1,0,0,0,1,0,0,0,1,1,1,nan"), InputError);
  EXPECT_THROW(parse_camera_text("0,0,0,1,0,0,0,1,0,0,0,1,0,1,1"), InputError);
}

}  // namespace
}  // namespace ps::document_test
