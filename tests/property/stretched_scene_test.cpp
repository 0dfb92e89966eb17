// A teapot that a scene stretches by 1e11: its triangles' boxes are so long that rounding puts hits outside of them.
// The watertight test has none there, so that all accelerators draw one picture.
#include <gtest/gtest.h>

#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/same_bits.h"
#include "support/settings_with.h"

namespace ps::stretched_scene_test {
namespace {

TEST(StretchedScene, IsOnePictureByAllAcceleratorsWithTheWatertightTest) {
  const Scene scene = load_scene("tests/corpus/scene/stretched.scene");
  const View view{scene.camera, 40, 30};
  Prepared prepared;
  Settings settings = settings_for(scene, Renderer::ray_tracer);
  settings.triangle_test = TriangleTest::watertight;
  const auto picture = [&](Accelerator accelerator) {
    settings.accelerator = accelerator;
    Progress progress;
    return render(scene, view, settings, {}, prepared, progress).colour;
  };
  const Image<Vec3f> expected = picture(Accelerator::none);
  for (const Accelerator accelerator :
       {Accelerator::bvh, Accelerator::bounding_spheres, Accelerator::box, Accelerator::octree, Accelerator::two_level})
    EXPECT_TRUE(test::same_bits(expected, picture(accelerator))) << static_cast<int>(accelerator);
}

}  // namespace
}  // namespace ps::stretched_scene_test
