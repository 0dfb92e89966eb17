// Handles of lights and spheres: places against the rays of the renderer's own viewport, and drags against both.
#include "gui/session/handles.h"

#include <gtest/gtest.h>

#include "frame/viewport.h"
#include "gui/tilted_view.h"
#include "scene/scene_file.h"

namespace ps::gui::handles_test {
namespace {

TEST(Handles, LieOnTheRayOfTheirPixel) {
  const View view = tilted_view();
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Settings settings;
    settings.projection = projection;
    const auto viewport = make_viewport<double>(view, settings);
    const Vec2d v = viewport.at(70, 150);  // the sample in the middle of that pixel
    const Camera& c = view.camera;
    const Vec3d across = c.right * v.x + c.up * v.y;
    const Vec3d point = projection == Projection::perspective
                            ? c.position + (across + c.forward * c.projection_plane_d) * 3.0
                            : c.position + across + c.forward * 3.0;
    const auto place = place_in_picture(view, settings, point);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 70.5, 1e-9);
    EXPECT_NEAR(place->y, 150.5, 1e-9);
    const Vec3d back = position_at(view, settings, point, *place);
    EXPECT_NEAR(back.x, point.x, 1e-9);
    EXPECT_NEAR(back.y, point.y, 1e-9);
    EXPECT_NEAR(back.z, point.z, 1e-9);
  }
}

TEST(Handles, NothingBehindTheCameraHasAPlace) {
  const View view = tilted_view();
  EXPECT_FALSE(place_in_picture(view, {}, view.camera.position));
  EXPECT_FALSE(place_in_picture(view, {}, view.camera.position - view.camera.forward));
}

TEST(Handles, BoxesAndModelsHaveOneAtTheirMiddle) {
  const Scene scene = parse_scene("model { name = sail vertices { (0, 0, 0) (2, 0, 0) (0, 2, 0) } "
                                  "triangles { (0, 1, 2, red) } }\n"
                                  "box { center = (0.5, 1, 6) size = (1, 2, 1) color = red }\n"
                                  "instance { model = sail position = (-1, 0, 5) }\n",
                                  "handles.scene", ".");
  View view;
  view.width = view.height = 200;
  const auto handles = handles_of(scene, view, {});
  ASSERT_EQ(handles.size(), 2u);
  EXPECT_EQ(handles[0].path, "object.0.center");
  EXPECT_EQ(handles[0].position, Vec3d(0.5, 1, 6));
  EXPECT_EQ(handles[0].offset, Vec3d(0, 0, 0));
  // A model's own origin may lie outside it: the handle is in its middle, and moves it by as much.
  EXPECT_EQ(handles[1].path, "object.1.translation");
  EXPECT_EQ(handles[1].position, Vec3d(0, 1, 5));
  EXPECT_EQ(handles[1].position + handles[1].offset, Vec3d(-1, 0, 5));
}

}  // namespace
}  // namespace ps::gui::handles_test
