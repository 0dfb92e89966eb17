// What happens behind the camera without clipping (CGFS ch. 9 and 11): the projection sends a point P and -P to one
// place, so what lies behind is drawn like its reflection in the camera; and the story says so.
#include <gtest/gtest.h>

#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::behind_camera_test {
namespace {

constexpr int size = 300;

/// The built-in scene with the cube behind the camera alone, or with that cube reflected in the camera.
Scene one_cube(double sign) {
  Scene scene = load_scene("cgfs/behind");
  scene.geometry.edit([&](Geometry& geometry) {
    std::erase_if(geometry.objects, [](const Object& object) { return object.name != "behind"; });
    auto& transform = std::get<Instance>(geometry.objects.at(0).shape).transform;
    transform.scale *= sign;
    transform.translation *= sign;
  });
  return scene;
}

Frame draw(const Scene& scene, Clipping clipping) {
  Settings settings = settings_for(scene);
  settings.clipping = clipping;
  settings.backface_culling = false;
  return render(scene, {scene.camera, size, size}, settings, request_for(Channel::ids));
}

int covered(const Frame& frame) {
  int count = 0;
  for (const PixelId& id : frame.ids.pixels()) count += id.object >= 0;
  return count;
}

TEST(BehindTheCamera, AnUnclippedCubeIsDrawnLikeItsReflection) {
  const Frame behind = draw(one_cube(1), Clipping::none), reflected = draw(one_cube(-1), Clipping::full);
  EXPECT_GT(covered(reflected), 4000);
  int differing = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      differing += (behind.ids.at(x, y).object >= 0) != (reflected.ids.at(x, y).object >= 0);
  EXPECT_EQ(differing, 0);
  EXPECT_EQ(covered(draw(one_cube(1), Clipping::full)), 0);
  EXPECT_EQ(covered(draw(one_cube(1), Clipping::near_only)), 0);
}

// The near plane alone gives the same picture as all planes: the picture's border does what the sides do.
TEST(BehindTheCamera, TheNearPlaneAloneGivesTheSamePicture) {
  const Scene scene = load_scene("cgfs/behind");
  const Frame full = draw(scene, Clipping::full), near = draw(scene, Clipping::near_only);
  EXPECT_TRUE(full.colour.pixels().size() == near.colour.pixels().size() &&
              std::equal(full.colour.pixels().begin(), full.colour.pixels().end(), near.colour.pixels().begin()));
  EXPECT_GT(near.counters[Counter::triangles_in], 0u);
  EXPECT_GT(full.counters[Counter::objects_culled], near.counters[Counter::objects_culled]);
}

TEST(BehindTheCamera, TheStorySaysSo) {
  const Scene scene = load_scene("cgfs/behind");
  Settings settings = settings_for(scene);
  settings.clipping = Clipping::none;
  const View view{scene.camera, 600, 600};
  const auto verdict = [&](Vec2i pixel) { return inspect(scene, view, settings, pixel).verdict; };
  EXPECT_NE(verdict({430, 230}).find("all its vertices lie behind the camera"), std::string::npos)
      << verdict({430, 230});
  EXPECT_EQ(verdict({180, 270}).find("behind the camera"), std::string::npos) << verdict({180, 270});
}

}  // namespace
}  // namespace ps::behind_camera_test
