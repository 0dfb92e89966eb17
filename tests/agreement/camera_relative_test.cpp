// A picture does not depend on where the world's origin is: the scene a million units away against the same scene at
// the origin.
#include <gtest/gtest.h>

#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::camera_relative_test {
namespace {

/// Moves the camera and all instances so that the camera stands at the origin; every number stays exact.
Scene brought_home(Scene scene) {
  const Vec3d offset = scene.camera.position;
  scene.camera.position = {0, 0, 0};
  scene.geometry.edit([&](Geometry& g) {
    for (Object& object : g.objects)
      if (auto* instance = std::get_if<Instance>(&object.shape))
        instance->transform.translation = instance->transform.translation - offset;
  });
  return scene;
}

int differing(const Scene& a, const Scene& b, bool relative) {
  Settings settings = settings_for(a);
  settings.camera_relative = relative;
  settings.lighting = false;
  const Frame first = render(a, {a.camera, 300, 300}, settings), second = render(b, {b.camera, 300, 300}, settings);
  int count = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x) count += first.colour.at(x, y) != second.colour.at(x, y);
  return count;
}

TEST(CameraRelative, MakesFarScenesEqualToNearOnes) {
  const Scene far = load_scene("lab/far-origin"), home = brought_home(far);
  // World positions near a million have steps of 1e-10 in double: a sample in a hundred thousand may change hands.
  EXPECT_LE(differing(far, home, true), 3);
  EXPECT_GT(differing(far, home, false), 300);
  EXPECT_EQ(differing(home, home, false), 0);
}

}  // namespace
}  // namespace ps::camera_relative_test
