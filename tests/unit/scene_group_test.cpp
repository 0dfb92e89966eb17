// Groups of instances: the product of the transforms around each, against angles and sums by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/load.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"
#include "scene/world.h"
#include "support/refusal.h"

namespace ps::scene_group_test {
namespace {

constexpr const char* model = "model { name = m vertices { (0, 0, 0) (1, 0, 0) (0, 1, 0) } triangles { (0, 1, 2) } }\n";

Scene parsed(const std::string& text) { return parse_scene(model + text, "test.scene", "."); }

const Transform& transform_of(const Scene& scene, std::size_t object) {
  return std::get<Instance>(scene.geometry->objects.at(object).shape).transform;
}

void expect_near(const Vec3d& a, const Vec3d& b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-12);
}

TEST(SceneGroup, MovesWhatItHolds) {
  const Scene scene = parsed("group { position = (1, 2, 3) instance { model = m position = (10, 0, 0) } }");
  EXPECT_EQ(transform_of(scene, 0).translation, Vec3d(11, 2, 3));
  EXPECT_EQ(transform_of(scene, 0).rotation, Mat3d(1.0));
}

/// A chain of links of length 1, each turned by 30 degrees more: link n ends at the sum of its cosines and sines.
TEST(SceneGroup, LinksOfAChainAddTheirAngles) {
  const std::string turn = "transform { rotation = <30 degrees around the Z axis> translation = (0, 1, 0) }\n";
  const std::string link = "instance { model = m }\n";
  const Scene scene = parsed("group { " + turn + link + "group { " + turn + link + "group { " + turn + link + "} } }");
  // The notation's positive angle about z turns y towards x or away from it; the first link says which.
  const Vec3d first = to_world(transform_of(scene, 0), {0, 1, 0}) - Vec3d(0, 1, 0);
  const double sense = first.x > 0 ? 1 : -1;
  EXPECT_NEAR(std::abs(first.x), 0.5, 1e-12);
  Vec3d joint(0, 0, 0);
  for (int n = 0; n < 3; ++n) {
    const double before = sense * n * std::acos(-1.0) / 6, angle = sense * (n + 1) * std::acos(-1.0) / 6;
    joint = joint + Vec3d(std::sin(before), std::cos(before), 0);
    expect_near(to_world(transform_of(scene, static_cast<std::size_t>(n)), {0, 0, 0}), joint);
    expect_near(to_world(transform_of(scene, static_cast<std::size_t>(n)), {0, 1, 0}),
                joint + Vec3d(std::sin(angle), std::cos(angle), 0));
  }
}

TEST(SceneGroup, GivesTransformsInEitherOrder) {
  const std::string turn = "rotation = <90 degrees around the Z axis>";
  const Scene turned_first = parsed("instance { model = m transform { " + turn + " translation = (2, 0, 0) } }");
  const Scene moved_first = parsed("group { transform { " + turn + " } instance { model = m position = (2, 0, 0) } }");
  expect_near(to_world(transform_of(turned_first, 0), {0, 0, 0}), {2, 0, 0});
  const Vec3d moved = to_world(transform_of(moved_first, 0), {0, 0, 0});
  EXPECT_NEAR(moved.x, 0, 1e-12);
  EXPECT_NEAR(std::abs(moved.y), 2, 1e-12);
}

/// A turned model in a group that stretches is sheared: right angles do not stay right, and normals stay normals.
TEST(SceneGroup, ShearsWhereAStretchFollowsATurn) {
  const Scene scene = parsed(
      "group { transform { scale = (3, 1, 1) } instance { model = m transform { rotation = <45 degrees around the Z "
      "axis> } } }");
  const Transform& t = transform_of(scene, 0);
  const Vec3d origin = to_world(t, {0, 0, 0});
  const Vec3d x = to_world(t, {1, 0, 0}) - origin, y = to_world(t, {0, 1, 0}) - origin;
  EXPECT_NEAR(std::abs(dot(x, y)), 4, 1e-12);  // (9 - 1) / 2
  const Mat3d normals = normal_matrix(t, NormalTransform::inverse_transpose);
  EXPECT_NEAR(dot(normals * Vec3d(1, 0, 0), y), 0, 1e-12);
  EXPECT_NEAR(dot(normals * Vec3d(0, 1, 0), x), 0, 1e-12);
}

TEST(SceneGroup, IsWrittenAsInstances) {
  const Scene scene = load_scene("lab/hierarchy");
  ASSERT_EQ(scene.geometry->objects.size(), 5u);
  const Scene again = parse_scene(write_scene(scene, "."), "again.scene", ".");
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(transform_of(again, i), transform_of(scene, i)) << i;
}

TEST(SceneGroup, RefusesWhatItCannotHold) {
  const auto message = [](const std::string& text) -> std::string { return test::refusal_of([&] { parsed(text); }); };
  EXPECT_NE(message("group { plane { point = (0, 0, 0) normal = (0, 1, 0) } }").find("plane"), std::string::npos);
  EXPECT_NE(message("group = 3"), "");
  std::string deep;
  for (int i = 0; i < 17; ++i) deep += "group { ";
  for (int i = 0; i < 17; ++i) deep += "} ";
  EXPECT_NE(message(deep), "");
  EXPECT_NE(message("group { transform { scale = 1e15 } group { transform { scale = 1e15 } instance { model = m } } }"),
            "");
}

}  // namespace
}  // namespace ps::scene_group_test
