// Gizmos: drags against the places where the renderer's own viewport puts points, and what they do to a scene.
#include "gui/session/gizmo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "gui/session/handles.h"
#include "gui/tilted_view.h"
#include "scene/edit.h"
#include "scene/load.h"
#include "scene/mesh.h"
#include "scene/scene_file.h"

namespace ps::gui::gizmo_test {
namespace {

Scene box_scene() {
  return parse_scene("box { center = (4, -1, 5) size = (1, 2, 3) rotation = <30 degrees around the X axis> "
                     "color = red }\n",
                     "box.scene", ".");
}

GizmoDrag drag_of(const Scene& scene, const View& view, const Settings& settings, GizmoPart part) {
  GizmoDrag drag;
  drag.gizmo = *gizmo_of(scene, 0);
  drag.part = part;
  drag.sight = {view, settings};
  drag.reach = 0.8;
  drag.scene = scene;
  drag.camera = view.camera;
  return drag;
}

Vec2d seen(const GizmoDrag& drag, const Vec3d& point) {
  return *place_in_picture(drag.sight.view, drag.sight.settings, point);
}

Scene after(const GizmoDrag& drag, double travel) {
  Scene scene = drag.scene;
  for (const SceneEdit& edit : gizmo_edits(drag, travel)) set_property(scene, edit.path, edit.value);
  return scene;
}

const Brick& brick_of(const Scene& scene) {
  return std::get<Brick>(std::get<Solid>(scene.geometry->objects.at(0).shape).form);
}

TEST(Gizmo, MovesAlongEachAxisToWhereThePointerIs) {
  const Scene scene = box_scene();
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Settings settings;
      settings.projection = projection;
      GizmoDrag drag = drag_of(scene, tilted_view(), settings, {GizmoDeed::move, axis});
      const Vec3d along = drag.gizmo.axes[axis];
      drag.from = seen(drag, drag.gizmo.centre + along * drag.reach);
      const auto travel = gizmo_travel(drag, seen(drag, drag.gizmo.centre + along * (drag.reach + 0.7)));
      ASSERT_TRUE(travel);
      EXPECT_NEAR(*travel, 0.7, 1e-9);
      const Vec3d moved = brick_of(after(drag, *travel)).centre;
      EXPECT_LT(glm::length(moved - (Vec3d(4, -1, 5) + along * 0.7)), 1e-3);
      EXPECT_EQ(brick_of(after(drag, *travel)).size, Vec3d(1, 2, 3));
    }
}

TEST(Gizmo, TurnsAboutEachAxisAsFarAsThePointerDoes) {
  const Scene scene = box_scene();
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double angle : {0.4, -1.1}) {
      GizmoDrag drag = drag_of(scene, tilted_view(), {}, {GizmoDeed::turn, axis});
      const Vec3d u = drag.gizmo.axes[(axis + 1) % 3] * drag.reach, v = drag.gizmo.axes[(axis + 2) % 3] * drag.reach;
      drag.from = seen(drag, drag.gizmo.centre + u);
      const auto travel = gizmo_travel(drag, seen(drag, drag.gizmo.centre + u * std::cos(angle) + v * std::sin(angle)));
      ASSERT_TRUE(travel);
      EXPECT_NEAR(*travel, angle, 1e-9) << axis;
      // The edge that the pointer took hold of is where it let go.
      const Mat3d turned = brick_of(after(drag, *travel)).rotation;
      const Vec3d expected = (u * std::cos(angle) + v * std::sin(angle)) / drag.reach;
      EXPECT_LT(glm::length(turned[static_cast<int>((axis + 1) % 3)] - expected), 1e-6);
    }
}

TEST(Gizmo, ARingSeenFromItsSideTurnsWithItsNearPart) {
  View view;
  view.width = view.height = 200;
  const Scene scene = parse_scene("box { center = (0, 0, 5) size = (1, 1, 1) color = red }\n", "box.scene", ".");
  GizmoDrag drag = drag_of(scene, view, {}, {GizmoDeed::turn, 1});
  drag.from = seen(drag, drag.gizmo.centre);
  // A small way along the picture's x is that way divided by the ring's radius, and its near part follows the pointer.
  const auto travel = gizmo_travel(drag, seen(drag, drag.gizmo.centre + Vec3d(drag.reach * 0.1, 0, 0)));
  ASSERT_TRUE(travel);
  EXPECT_NEAR(std::abs(*travel), 0.1, 1e-9);
  const Vec3d near_part = Mat3d(brick_of(after(drag, *travel)).rotation) * Vec3d(0, 0, -1);
  EXPECT_GT(near_part.x, 0.09);
}

TEST(Gizmo, ScalesOneSizeByTheRatioOfTheDistances) {
  const Scene scene = box_scene();
  GizmoDrag drag = drag_of(scene, tilted_view(), {}, {GizmoDeed::scale, 2});
  const Vec3d along = drag.gizmo.axes[2];
  drag.from = seen(drag, drag.gizmo.centre + along * 1.2);
  const auto travel = gizmo_travel(drag, seen(drag, drag.gizmo.centre + along * 1.8));
  ASSERT_TRUE(travel);
  EXPECT_NEAR(*travel, 1.5, 1e-9);
  EXPECT_EQ(brick_of(after(drag, *travel)).size, Vec3d(1, 2, 4.5));
  EXPECT_EQ(brick_of(after(drag, *travel)).centre, Vec3d(4, -1, 5));
}

TEST(Gizmo, AModelTurnsAndGrowsAboutItsMiddle) {
  Scene scene = load_scene("models/dice");
  std::size_t object = 0;
  while (!std::holds_alternative<Instance>(scene.geometry->objects.at(object).shape)) ++object;
  const Gizmo before = *gizmo_of(scene, object);
  for (const GizmoPart part : {GizmoPart{GizmoDeed::turn, 0}, GizmoPart{GizmoDeed::scale, 1}}) {
    GizmoDrag drag;
    drag.gizmo = before;
    drag.part = part;
    drag.scene = scene;
    const Scene changed = after(drag, 1.4);
    EXPECT_LT(glm::length(gizmo_of(changed, object)->centre - before.centre), 1e-3);
    const Transform &was = std::get<Instance>(scene.geometry->objects.at(object).shape).transform,
                    &is = std::get<Instance>(changed.geometry->objects.at(object).shape).transform;
    if (part.deed == GizmoDeed::turn)
      EXPECT_NE(is.rotation, was.rotation);
    else
      EXPECT_NEAR(is.scale.y, was.scale.y * 1.4, 1e-3 * was.scale.y);
  }
}

TEST(Gizmo, TheCameraMovesAndTurnsWithoutChangingItsFrame) {
  const Camera camera = tilted_view().camera;
  GizmoDrag drag;
  drag.gizmo = gizmo_of(camera);
  drag.camera = camera;
  drag.part = {GizmoDeed::move, 2};
  EXPECT_LT(glm::length(dragged_camera(drag, 2).position - (camera.position + Vec3d(1.2, 0, 1.6))), 1e-12);
  drag.part = {GizmoDeed::turn, 1};
  const Camera turned = dragged_camera(drag, std::numbers::pi / 2);
  EXPECT_EQ(turned.position, camera.position);
  EXPECT_NEAR(glm::length(turned.right), 1, 1e-12);
  EXPECT_NEAR(dot(turned.right, camera.right), 0, 1e-12);
  EXPECT_LT(glm::length(turned.up - camera.up), 1e-12);
  EXPECT_FALSE(drag.gizmo.scales);
}

TEST(Gizmo, AnAxisThatPointsAtTheEyeSaysNothing) {
  View view;
  view.width = view.height = 200;
  const Scene scene = parse_scene("box { center = (0, 0, 5) size = (1, 1, 1) color = red }\n", "box.scene", ".");
  GizmoDrag drag = drag_of(scene, view, {}, {GizmoDeed::move, 2});
  drag.from = {100, 100};
  EXPECT_FALSE(gizmo_travel(drag, {120, 100}));
}

TEST(Gizmo, CsgObjectsHaveNone) {
  const Scene scene = load_scene("cgfs/death-star");
  EXPECT_FALSE(gizmo_of(scene, 0));
  EXPECT_FALSE(gizmo_of(scene, 10000));
}

}  // namespace
}  // namespace ps::gui::gizmo_test
