// Moving the camera by hand: what must hold for any frame, whichever way its axes point.
#include "gui/session/camera_moves.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>
#include <random>

namespace ps::gui::camera_moves_test {
namespace {

constexpr double tiny = 1e-9;
constexpr double quarter = std::numbers::pi / 2;

/// The book's frame, that of a right-handed scene looking along -z, and one with y downwards.
const Camera book{};
Camera looking_back() {
  Camera camera;
  camera.forward = {0, 0, -1};
  return camera;
}
Camera upside_down() {
  Camera camera;
  camera.up = {0, -1, 0};
  return camera;
}

void expect_near(const Vec3d& a, const Vec3d& b) {
  EXPECT_NEAR(a.x, b.x, tiny);
  EXPECT_NEAR(a.y, b.y, tiny);
  EXPECT_NEAR(a.z, b.z, tiny);
}

TEST(CameraMoves, TurningRightLooksWhereRightWas) {
  for (const Camera& camera : {book, looking_back(), upside_down()}) {
    const Camera turned_camera = turned(camera, quarter, 0, camera.up);
    expect_near(turned_camera.forward, camera.right);
    expect_near(turned_camera.right, -camera.forward);
    expect_near(turned_camera.up, camera.up);
    expect_near(turned_camera.position, camera.position);
  }
}

TEST(CameraMoves, TurningUpLooksUpButNotOver) {
  for (const Camera& camera : {book, looking_back(), upside_down()}) {
    EXPECT_GT(dot(turned(camera, 0, 0.3, camera.up).forward, camera.up), 0.29);
    EXPECT_LT(dot(turned(camera, 0, -0.3, camera.up).forward, camera.up), -0.29);
    const Camera steep = turned(camera, 0, 10, camera.up);
    EXPECT_LT(dot(steep.forward, camera.up), 1 - 1e-3);
    EXPECT_GT(dot(steep.up, camera.up), 0) << "it did not go over the top";
  }
}

TEST(CameraMoves, AnyTurnKeepsTheShapeOfTheFrame) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> angle(-1, 1);
  Camera camera;
  camera.right = {1.5, 0, 0};  // not orthonormal
  camera.forward = {0.2, 0, 1};
  for (int i = 0; i < 200; ++i) {
    const Camera next = i % 2 ? turned(camera, angle(random), angle(random), book.up)
                              : orbited(camera, angle(random), angle(random), book.up, {0, 1, 5});
    EXPECT_NEAR(dot(next.right, next.right), 1.5 * 1.5, 1e-6);
    EXPECT_NEAR(dot(next.right, next.forward), 1.5 * 0.2, 1e-6);
    EXPECT_NEAR(dot(next.up, next.forward), 0, 1e-6);
    camera = next;
  }
}

TEST(CameraMoves, OrbitKeepsDistanceAndPlaceInThePicture) {
  const Vec3d pivot(1, -0.5, 6);
  const Camera camera = orbited(book, 0.7, 0.2, book.up, pivot);
  EXPECT_NEAR(glm::length(camera.position - pivot), glm::length(book.position - pivot), tiny);
  // The pivot stays where it is seen: the same coordinates in the camera's frame.
  const Vec3d before = pivot - book.position, after = pivot - camera.position;
  EXPECT_NEAR(dot(after, camera.right), dot(before, book.right), tiny);
  EXPECT_NEAR(dot(after, camera.up), dot(before, book.up), tiny);
  EXPECT_NEAR(dot(after, camera.forward), dot(before, book.forward), tiny);
}

TEST(CameraMoves, LightsMoveAlongTheCamerasAxes) {
  Light light;
  light.kind = LightKind::point;
  light.position = {2, 1, 0};
  expect_near(moved_light(light, book, 0.5, 0, 2, 3).position, {2.5, 1, 2});
  light.kind = LightKind::ambient;
  EXPECT_EQ(moved_light(light, book, 0.5, 0, 2, 3), light);
  light.kind = LightKind::directional;
  light.direction = {1, 4, 4};
  const Light turned_light = moved_light(light, book, 1, 0, 0, 3);
  EXPECT_NEAR(glm::length(turned_light.direction), glm::length(light.direction), tiny);
  EXPECT_GT(turned_light.direction.x, 1);
}

}  // namespace
}  // namespace ps::gui::camera_moves_test
