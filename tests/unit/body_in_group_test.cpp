// Spheres, boxes and cylinders on their own inside groups: against the same bodies placed by hand, against closed
// forms, and in both renderers against each other and against parts of CSG.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene/rotation.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"
#include "support/refusal.h"
#include "support/render_once.h"

namespace ps::body_in_group_test {
namespace {

constexpr int side = 96;

Scene parsed_bodies(const std::string& text) {
  return parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                     "light { type = ambient intensity = 1 }\n" +
                         text,
                     "group.scene", ".");
}

Frame drawn(const Scene& scene, Renderer renderer, Projection projection = Projection::perspective) {
  Settings settings{.renderer = renderer};
  settings.precision = Precision::float64;
  settings.projection = projection;
  settings.backface_culling = true;
  return render(scene, {scene.camera, side, side}, settings,
                request_for(Channel::depth | Channel::normal | Channel::uv | Channel::ids));
}

const std::string ball = "sphere { center = (0.25, 0, 0) radius = 0.5 color = red }\n";
const std::string box = "box { center = (0.1, 0.2, 0) size = (0.7, 0.5, 0.6) color = red }\n";
const std::string cylinder = "cylinder { from = (-0.2, -0.4, 0) to = (0.3, 0.4, 0.2) radius = 0.3 color = red }\n";
const std::string globe = "texture { name = t generator = checker }\n";

TEST(BodyInGroup, KeepsItsKindWhereTheMapKeepsShapes) {
  const Scene scene =
      parsed_bodies("group { position = (0, 0, 1) group { transform { scale = 2 translation = (1, 2, 3) "
                    "} " +
                    ball + box + cylinder + "} }");
  const auto& objects = scene.geometry->objects;
  ASSERT_EQ(objects.size(), 3u);
  const auto* sphere = std::get_if<Sphere>(&objects[0].shape);
  ASSERT_TRUE(sphere);
  EXPECT_EQ(sphere->centre, Vec3d(1.5, 2, 4));
  EXPECT_EQ(sphere->radius, 1);
  const Solid& brick = std::get<Solid>(objects[1].shape);
  EXPECT_TRUE(brick.place.is_identity());
  EXPECT_EQ(std::get<Brick>(brick.form), (Brick{{1.2, 2.4, 4}, {1.4, 1, 1.2}, Mat3d(1.0)}));
  const Solid& tube = std::get<Solid>(objects[2].shape);
  EXPECT_TRUE(tube.place.is_identity());
  EXPECT_EQ(std::get<Cylinder>(tube.form), (Cylinder{{0.6, 1.2, 4}, {1.6, 2.8, 4.4}, 0.6}));
}

TEST(BodyInGroup, TurnsLikeABodyPlacedByHand) {
  const std::string turn = "rotation = <30 degrees around the Z axis>";
  const Mat3d rotation = rotation_about(Axis::z, 30);
  const Scene scene = parsed_bodies("group { transform { " + turn + " scale = 3 translation = (0, 1, 5) } " + ball +
                                    box + cylinder + "}");
  const auto& objects = scene.geometry->objects;
  const auto moved = [&](const Vec3d& p) { return rotation * (p * 3.0) + Vec3d(0, 1, 5); };
  const auto expect_near = [](const Vec3d& a, const Vec3d& b) { EXPECT_LT(glm::distance(a, b), 1e-12); };
  const auto* sphere = std::get_if<Sphere>(&objects[0].shape);
  ASSERT_TRUE(sphere);
  expect_near(sphere->centre, moved({0.25, 0, 0}));
  EXPECT_NEAR(sphere->radius, 1.5, 1e-15);
  const auto& brick = std::get<Brick>(std::get<Solid>(objects[1].shape).form);
  expect_near(brick.centre, moved({0.1, 0.2, 0}));
  expect_near(brick.size, {2.1, 1.5, 1.8});
  for (int axis = 0; axis < 3; ++axis) expect_near(brick.rotation[axis], rotation[axis]);
  const auto& tube = std::get<Cylinder>(std::get<Solid>(objects[2].shape).form);
  expect_near(tube.to, moved({0.3, 0.4, 0.2}));
  EXPECT_NEAR(tube.radius, 0.9, 1e-15);
}

struct Stretch {
  const char* name;
  std::string transform;
  const char* texture;
};
const std::vector<Stretch> stretches{
    {"stretched", "scale = (1.6, 0.6, 1.1) translation = (0, 0.1, 3)", ""},
    {"sheared", "scale = (1.5, 0.7, 1) rotation = <40 degrees around the Y axis> translation = (0, 0, 3)", ""},
    {"mirrored", "scale = (-1.4, 0.8, 1) translation = (0.1, 0, 3)", ""},
    {"turned with its picture", "rotation = <50 degrees around the X axis> translation = (0, 0, 3)", "texture = t"}};

/// The body, in a group within a group, so that turns come before and after the stretch.
std::string grouped(const Stretch& stretch, std::string body) {
  body.insert(body.rfind('}'), std::string(stretch.texture) + " ");
  return "group { transform { " + stretch.transform +
         " } group { transform { rotation = <20 degrees around the Z axis> } " + body + " } }\n";
}

TEST(BodyInGroup, IsTracedAsAPartOfCsgIs) {
  for (const Stretch& stretch : stretches)
    for (const std::string& body : {ball, box, cylinder}) {
      const std::string text = grouped(stretch, body);
      const Frame alone = drawn(parsed_bodies(globe + text), Renderer::ray_tracer);
      const Frame part =
          drawn(parsed_bodies(globe + "union { " + text + " sphere { center = (0, 0, -99) radius = 1 } }"),
                Renderer::ray_tracer);
      int hits = 0;
      double farthest = 0;
      for (std::size_t i = 0; i < alone.ids.pixels().size(); ++i) {
        ASSERT_EQ(alone.ids.pixels()[i], part.ids.pixels()[i]) << stretch.name << ": " << body;
        if (alone.ids.pixels()[i].object < 0) continue;
        ++hits;
        const auto& a = alone;
        farthest = std::max({farthest, std::abs(double(a.depth.pixels()[i]) - double(part.depth.pixels()[i])),
                             double(glm::distance(a.normal.pixels()[i], part.normal.pixels()[i]))});
      }
      EXPECT_GT(hits, 150) << stretch.name << ": " << body;
      EXPECT_LT(farthest, 1e-5) << stretch.name << ": " << body;
    }
}

/// Does the picture show the same around the pixel?
bool is_inside(const Frame& frame, int x, int y) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (frame.ids.at(x + dx, y + dy) != frame.ids.at(x, y)) return false;
  return true;
}

TEST(BodyInGroup, IsDrawnByTheRasterizerWhereRaysMeetIt) {
  for (const Stretch& stretch : stretches)
    for (const std::string& body : {ball, box, cylinder})
      for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Scene scene = parsed_bodies(globe + grouped(stretch, body));
        const Frame rays = drawn(scene, Renderer::ray_tracer, projection);
        const Frame fragments = drawn(scene, Renderer::rasterizer, projection);
        int compared = 0, wrong_ids = 0, wrong_depths = 0, wrong_normals = 0, wrong_uvs = 0;
        for (int y = 1; y + 1 < side; ++y)
          for (int x = 1; x + 1 < side; ++x) {
            if (!is_inside(rays, x, y)) continue;  // a pixel beside the silhouette
            wrong_ids += rays.ids.at(x, y) != fragments.ids.at(x, y);
            if (rays.ids.at(x, y).object < 0 || fragments.ids.at(x, y).object < 0) continue;
            ++compared;
            // Half a pixel's chord error; edges between a body's faces lie inside its outline.
            wrong_depths += std::abs(rays.depth.at(x, y) - fragments.depth.at(x, y)) > 0.05f;
            wrong_normals += glm::distance(rays.normal.at(x, y), fragments.normal.at(x, y)) > 0.15f;
            const Vec2f uv = glm::abs(rays.uv.at(x, y) - fragments.uv.at(x, y));
            const float across = std::abs(uv.x - std::round(uv.x));  // the seam of a world map repeats
            wrong_uvs += stretch.texture[0] != 0 && (across > 0.03f || uv.y > 0.03f);
          }
        const std::string what = std::string(stretch.name) + ": " + body;
        EXPECT_GT(compared, 150) << what;
        EXPECT_EQ(wrong_ids, 0) << what;
        for (const int wrong : {wrong_depths, wrong_normals, wrong_uvs}) EXPECT_LE(wrong, compared / 10) << what;
      }
}

TEST(BodyInGroup, IsWrittenAndReadBack) {
  std::string text = globe;
  for (const Stretch& stretch : stretches)
    for (const std::string& body : {ball, box, cylinder}) text += grouped(stretch, body);
  const Scene scene = parsed_bodies(text);
  const Scene again = parse_scene(write_scene(scene, "."), "again.scene", ".");
  ASSERT_EQ(again.geometry->objects.size(), 12u);
  int placed = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto& shape = scene.geometry->objects[i].shape;
    EXPECT_EQ(shape.index(), again.geometry->objects[i].shape.index()) << i;
    if (const auto* solid = std::get_if<Solid>(&shape)) {
      const Solid& read = std::get<Solid>(again.geometry->objects[i].shape);
      EXPECT_EQ(solid->form, read.form) << i;
      EXPECT_EQ(solid->place, read.place) << i;
      placed += !solid->place.is_identity();
    }
  }
  EXPECT_EQ(placed, 11);  // the turned box keeps its picture by its own axes
}

TEST(BodyInGroup, RefusesWhatItCannotPlace) {
  const auto message = [](const std::string& text) -> std::string {
    return test::refusal_of([&] { parsed_bodies(text); });
  };
  EXPECT_NE(message("group { plane { point = (0, 0, 0) normal = (0, 1, 0) } }").find("'plane' inside 'group'"),
            std::string::npos);
  EXPECT_NE(message("group { rectangle { corner = (0, 0, 0) side_a = (1, 0, 0) side_b = (0, 1, 0) } }"), "");
  EXPECT_NE(message("group { transform { scale = (1, 1, 1e-12) } " + ball + "}").find("too small"), std::string::npos);
  EXPECT_EQ(message("group { transform { scale = (1, 1, 1e-3) } " + ball + "}"), "");
}

}  // namespace
}  // namespace ps::body_in_group_test
