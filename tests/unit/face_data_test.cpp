// The names, the line and the normals that a model's file gives a triangle, in the stories of all renderers.
#include "inspect/face_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "inspect/describe.h"
#include "inspect/microscope/drawing.h"
#include "inspect/story_json.h"
#include "inspect/vertex_uses.h"
#include "math/unit.h"
#include "obj_corpus.h"
#include "render/story/names.h"
#include "support/render_once.h"

namespace ps::face_data_test {
namespace {

/// Two triangles that fill the view of a camera on +z: the lower right one, in line 13, has the normal of vertex 1
/// turned to its back; the upper left one, in line 18, is sound.
const char* const model = R"(mtllib m.mtl
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
vt 0 0
vt 1 0
vt 1 1
vn 0 0 2
vn 0 0.6 -0.8
usemtl ivory
o Head
f 1/1/1 2/2/2 3/3/1
o Hat
g brim left
usemtl felt

f 1/1/1 3/3/1 4/1/1
)";

Scene load_model() {
  const test::ModelFolder folder;
  folder.write("m.mtl", "newmtl ivory\nKd 1 1 0.9\nnewmtl felt\nKd 0.2 0.2 0.2\n");
  return folder.load(model);
}

View view_on(const Scene& scene) {
  View view{scene.camera, 90, 90};
  view.camera.position = {0, 0, 4};
  view.camera.right = {1, 0, 0};
  view.camera.up = {0, 1, 0};
  view.camera.forward = {0, 0, -1};
  view.camera.projection_plane_d = view.camera.viewport_width = view.camera.viewport_height = 1;
  return view;
}

constexpr Vec2i in_head{60, 60}, in_hat{30, 30};

const Event* shown_event(const PixelStory& story) {
  const int event = event_of_shown(story);
  return event < 0 ? nullptr : &story.events[static_cast<std::size_t>(event)];
}

std::optional<EventField> field_of(const Event& event, const Scene& scene, std::string_view key) {
  for (const EventField& field : event_fields(event.data, scene))
    if (field.key == key) return field;
  return {};
}

std::string text_of(const Event& event, const Scene& scene, std::string_view key) {
  const auto field = field_of(event, scene, key);
  const auto* text = field ? std::get_if<std::string>(&field->value) : nullptr;
  return text ? *text : "none";
}

Vec3d vector_of(const Event& event, const Scene& scene, std::string_view key) {
  const auto field = field_of(event, scene, key);
  const auto* v = field ? std::get_if<std::vector<double>>(&field->value) : nullptr;
  if (!v || v->size() < 2) return Vec3d(-100);
  return {(*v)[0], (*v)[1], v->size() > 2 ? (*v)[2] : 0};
}

TEST(FaceData, NamesLineAndCornersAreThoseOfTheFile) {
  const Scene scene = load_model();
  const auto head = face_data(scene, {0, 0}), hat = face_data(scene, {0, 1});
  ASSERT_TRUE(head && hat);
  EXPECT_EQ(head->object + "|" + head->group + "|" + head->material, "Head||ivory");
  EXPECT_EQ(hat->object + "|" + hat->group + "|" + hat->material, "Hat|brim left|felt");
  EXPECT_EQ(head->line, 13);
  EXPECT_EQ(hat->line, 18);
  EXPECT_TRUE(head->file.ends_with(".obj")) << head->file;
  EXPECT_EQ(head->corners[0].normal, Vec3d(0, 0, 1)) << "of length 1";
  EXPECT_EQ(head->corners[1].normal, Vec3d(0, 0.6, -0.8));
  EXPECT_EQ(head->corners[2].uv, Vec2d(1, 0)) << "v is turned over";
  EXPECT_EQ(hat->corners[2].vertex, 3);
  EXPECT_EQ(facing_text(*head), "the normal of vertex 1 faces away from its face");
  EXPECT_EQ(facing_text(*hat), "");
  EXPECT_NE(origin_text(*hat).find("Hat, group brim left, material felt, line 18 of "), std::string::npos);
  EXPECT_FALSE(face_data(scene, {0, 2}));
  EXPECT_FALSE(face_data(scene, {0, -1}));
  EXPECT_FALSE(face_data(scene, {1, 0}));
  EXPECT_EQ(primitive_name(scene, {0, 1}), "triangle 1 of " + object_name(scene, 0) + " (Hat)");
}

/// A mirrored and stretched instance turns normals and faces alike, so that the same normal faces away.
TEST(FaceData, FacingHoldsInPlacedModels) {
  Scene scene = load_model();
  scene.geometry.edit([](Geometry& geometry) {
    auto& transform = std::get<Instance>(geometry.objects[0].shape).transform;
    transform.scale = {-2, 1, 3};
    transform.rotation = Mat3d(Vec3d(0, 1, 0), Vec3d(-1, 0, 0), Vec3d(0, 0, 1));
  });
  const auto head = face_data(scene, {0, 0});
  ASSERT_TRUE(head);
  EXPECT_EQ(facing_text(*head), "the normal of vertex 1 faces away from its face");
  EXPECT_NEAR((*head->corners[1].normal).y, 0, 1e-15);
  // (0, 0.6, -0.8) by the inverse scale is (0, 0.6, -0.8 / 3), and the turn takes y to -x.
  const double length = std::sqrt(0.6 * 0.6 + 0.8 * 0.8 / 9);
  EXPECT_NEAR((*head->corners[1].normal).x, -0.6 / length, 1e-12);
  EXPECT_NEAR((*head->corners[1].normal).z, -0.8 / 3 / length, 1e-12);
}

/// Rays and triangles report the same about a pixel, and at its point the normal that the ray tracer shades with.
TEST(FaceData, StoriesOfAllRenderersReportIt) {
  const Scene scene = load_model();
  const View view = view_on(scene);
  std::optional<Vec3d> traced_normal, traced_uv;
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    const PixelStory story = inspect(scene, view, settings, in_head);
    const Event* event = shown_event(story);
    ASSERT_NE(event, nullptr);
    EXPECT_EQ(text_of(*event, scene, "file-object"), "Head");
    EXPECT_EQ(text_of(*event, scene, "material"), "ivory");
    EXPECT_EQ(text_of(*event, scene, "normals-away"), "vertex 1");
    EXPECT_EQ(vector_of(*event, scene, "vertex-normal-1"), Vec3d(0, 0.6, -0.8));
    EXPECT_EQ(vector_of(*event, scene, "vertex-uv-2"), Vec3d(1, 0, 0));
    const std::string text = describe(*event, scene);
    EXPECT_NE(text.find("Head, material ivory, line 13 of"), std::string::npos) << text;
    EXPECT_NE(text.find("the normal of vertex 1 faces away from its face"), std::string::npos) << text;
    EXPECT_NE(story.verdict.find("(Head)"), std::string::npos) << story.verdict;
    if (const auto* hit = std::get_if<HitEvent>(&event->data)) {
      traced_normal = hit->shading_normal;
      traced_uv = Vec3d(hit->uv, 0);
    } else {
      ASSERT_TRUE(traced_normal);
      EXPECT_NEAR(length_of(vector_of(*event, scene, "point-normal") - *traced_normal), 0, 1e-5);
      EXPECT_NEAR(length_of(vector_of(*event, scene, "point-uv") - *traced_uv), 0, 1e-5);
    }
    const auto json = nlohmann::json::parse(story_json(story, scene, view, {}));
    const auto& said = json["events"][static_cast<std::size_t>(event_of_shown(story))];
    EXPECT_EQ(said["face-line"], 13);
    EXPECT_EQ(said["model-file"], scene.name);
    const PixelStory sound = inspect(scene, view, settings, in_hat);
    EXPECT_EQ(sound.verdict.find("Head"), std::string::npos);
    ASSERT_NE(shown_event(sound), nullptr);
    EXPECT_EQ(text_of(*shown_event(sound), scene, "normals-away"), "none");
    EXPECT_EQ(describe(*shown_event(sound), scene).find("faces away"), std::string::npos);
  }
}

TEST(FaceData, TheMicroscopeShowsItForRaysAndTriangles) {
  const Scene scene = load_model();
  const View view = view_on(scene);
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    Prepared prepared;
    Progress progress;
    const Microscope scope(scene, view, settings, in_head, prepared, progress);
    const MicroReading reading = scope.read({0.5, 0.5}, prepared, progress);
    std::vector<MicroTable> tables;
    std::optional<FaceData> face;
    if (reading.face) {
      tables = face_tables(*reading.face);
      face = reading.face->face;
    } else {
      ASSERT_GE(reading.front, 0);
      const MicroTriangle& front = reading.triangles[static_cast<std::size_t>(reading.front)];
      tables = triangle_tables(front);
      face = front.face;
    }
    ASSERT_TRUE(face);
    EXPECT_EQ(face->line, 13);
    const auto has = [&](const std::string& column, const std::string& row, const std::vector<std::string>& values) {
      return std::any_of(tables.begin(), tables.end(), [&](const MicroTable& table) {
        return table.columns.front() == column &&
               std::any_of(table.rows.begin(), table.rows.end(),
                           [&](const MicroRow& one) { return one.name == row && one.values == values; });
      });
    };
    EXPECT_TRUE(has("vertex 0", "normal z", {"1", "-0.8", "1"}));
    EXPECT_TRUE(has("vertex 0", "u", {"0", "1", "1"}));
    EXPECT_TRUE(std::any_of(tables.begin(), tables.end(),
                            [](const MicroTable& table) { return table.columns.front() == "at the point"; }));
  }
}

TEST(FaceData, AVertexNamesTheTrianglesAtIt) {
  const Scene scene = load_model();
  const VertexUses uses = vertex_uses(scene, {0, 2});
  ASSERT_EQ(uses.count, 2u);
  ASSERT_EQ(uses.first.size(), 2u);
  EXPECT_EQ(uses.first[0].corner, 2);
  EXPECT_EQ(uses.first[1].corner, 1);
  EXPECT_TRUE(
      use_text(uses.first[0]).starts_with("triangle 0: normal (0, 0, 1), uv (1, 0); Head, material ivory, line 13 of "))
      << use_text(uses.first[0]);
  const VertexUses turned = vertex_uses(scene, {0, 1}, 1);
  EXPECT_TRUE(use_text(turned.first[0]).ends_with("; the normal faces away from the face"));
  EXPECT_EQ(vertex_uses(scene, {0, 2}, 1).first.size(), 1u);
}

}  // namespace
}  // namespace ps::face_data_test
