// self-hit = exclusion (CGPP 15.4.8): a ray does not test the surface that it leaves. Right for triangles and for
// spheres seen from outside; wrong for what a ray can leave and meet again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "options/option.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"

namespace ps::exclusion_test {
namespace {

Frame picture(const Scene& scene, SelfHit guard, int side = 61) {
  Settings settings;
  settings.self_hit = guard;
  settings.near = 0.01;
  return render(scene, {scene.camera, side, side}, settings, {});
}

double brightness(const Scene& scene, SelfHit guard) {
  const Frame drawn = picture(scene, guard);
  double sum = 0;
  for (const Vec3f& colour : drawn.colour.pixels()) sum += static_cast<double>(colour.y);
  return sum / (61 * 61);
}

Scene of(const std::string& objects) {
  return parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n" + objects, "one.scene", ".");
}

// In the book's scene a surface never blocks its own light, so no shadow is lost. Where a surface's point is rounded to
// its inside, the sphere that is not tested cannot be met.
TEST(Exclusion, SpheresFromOutsideHaveNoAcne) {
  const Scene scene = load_scene("cgfs/shadows");
  const Frame offset = picture(scene, SelfHit::offset, 120), excluded = picture(scene, SelfHit::exclusion, 120);
  int differing = 0;
  for (std::size_t i = 0; i < offset.colour.pixels().size(); ++i) {
    const Vec3f d = offset.colour.pixels()[i] - excluded.colour.pixels()[i];
    differing += std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > 0.004f;
  }
  std::cout << differing << " of 14400 pixels differ\n";
  EXPECT_LE(differing, 30);  // at the horizon of a ball, where the light grazes it
}

// A ray that has entered a glass ball is to leave it on the other side. Exclusion does not test the ball again.
TEST(Exclusion, GlassHasNoFarSide) {
  const Scene glass =
      of("sphere { center = (0, 0, 3)  radius = 1  color = white  transparency = 1  refraction_index = 1.5 }\n");
  const auto rays = [&](SelfHit guard) {
    const Frame frame = picture(glass, guard);
    return *frame.counters.get(Counter::refraction_rays);
  };
  const std::uint64_t once = rays(SelfHit::exclusion), twice = rays(SelfHit::offset);
  EXPECT_GT(once, 1000u);
  EXPECT_EQ(twice, 2 * once);
}

/// Where the ray of a pixel meets the plane at distance 1 from the eye: right and up.
Vec2d on_plane(int x, int y) { return {(x + 0.5) / 61 - 0.5, 0.5 - (y + 0.5) / 61}; }

// A brick with a hole, seen from above: its wall at x = 1 is 1.25 high and shades the floor of the hole as far as the
// light, which falls half a unit for each unit of height, misses it. Exclusion tests no part of the brick again.
TEST(Exclusion, AHollowSolidDoesNotShadowItself) {
  const Scene hollow = of("camera { position = (0, 6, 0)  forward = (0, -1, 0)  up = (0, 0, 1)  right = (1, 0, 0) }\n"
                          "difference {\n  box { center = (0, 0, 0)  size = (3, 2, 3)  color = white }\n"
                          "  box { center = (0, 1, 0)  size = (2, 2.5, 2)  color = white }\n}\n"
                          "light { type = directional  intensity = 1  direction = (0.5, 1, 0) }\n");
  const Frame offset = picture(hollow, SelfHit::offset), excluded = picture(hollow, SelfHit::exclusion);
  const float lit = 1 / std::sqrt(1.25f);
  int dark = 0;
  for (int y = 0; y < 61; ++y)
    for (int x = 0; x < 61; ++x) {
      const Vec2d floor = on_plane(x, y) * 6.25;  // of the hole, below the eye
      if (std::max(std::abs(floor.x), std::abs(floor.y)) > 0.98) continue;
      EXPECT_NEAR(excluded.colour.at(x, y).y, lit, 1e-5f) << floor.x;
      EXPECT_NEAR(offset.colour.at(x, y).y, floor.x > 1 - 0.5 * 1.25 ? 0 : lit, 1e-5f) << floor.x;
      dark += offset.colour.at(x, y).y == 0 ? 1 : 0;
    }
  EXPECT_GT(dark, 100);
}

// Two triangles in the same place: the one that is left is not tested, but its twin is. A point that rounding puts
// behind it is dark, any other fully lit. The offset is larger than the rounding, so that the twin is never met.
TEST(Exclusion, ATwinInTheSamePlaceStillBlocks) {
  const std::string one =
      "triangle { vertices = [(-3, -2.3, 3.1), (0.2, 3.7, 7.3), (3.4, -1.9, 4.7)]  color = white }\n";
  const std::string light = "light { type = directional  intensity = 1  direction = (0.3, 0.7, -1.1) }\n";
  const auto levels = [&](const std::string& objects, SelfHit guard) {
    const Frame frame = picture(of(objects + light), guard);
    std::map<bool, int> count;  // of the pixels that show the triangles, by whether they are lit
    const Vec3d normal = cross(Vec3d(3.2, 6, 4.2), Vec3d(6.4, 0.4, 1.6)), to_light(0.3, 0.7, -1.1);
    const double cosine = std::abs(dot(normal, to_light)) / std::sqrt(dot(normal, normal) * dot(to_light, to_light));
    for (int y = 30; y < 40; ++y)
      for (int x = 25; x < 36; ++x) {
        const float level = frame.colour.at(x, y).y;
        ++count[level > 0];
        if (level > 0) {
          EXPECT_NEAR(level, cosine, 1e-5);
        }
      }
    return count;
  };
  EXPECT_EQ(levels(one, SelfHit::exclusion)[false], 0);
  EXPECT_EQ(levels(one + one, SelfHit::offset)[false], 0);
  std::map<bool, int> twins = levels(one + one, SelfHit::exclusion);
  std::cout << twins[false] << " of 110 pixels are dark\n";
  EXPECT_GT(twins[false], 10);
  EXPECT_GT(twins[true], 10);
}

// A triangle is flat: a ray that leaves it never meets it again. Its neighbours are other triangles, and still block.
TEST(Exclusion, AConcaveMeshKeepsItsShadows) {
  const std::string gable =
      "model { name = valley\n"
      "  vertices { 0 = (-2, 2, 2)  1 = (0, -1, 2)  2 = (2, 2, 2)  3 = (-2, 2, 6)  4 = (0, -1, 6)  "
      "5 = (2, 2, 6) }\n"
      "  triangles { 0 = { vertices = [0, 3, 4] color = white }  1 = { vertices = [0, 4, 1] color = "
      "white }  2 = { vertices = [1, 4, 5] color = white }  3 = { vertices = [1, 5, 2] color = "
      "white } }\n}\n"
      "instance { model = valley }\n"
      "camera { position = (0, 5, 0)  forward = (0, -1, 1)  up = (0, 1, 1)  right = (1, 0, 0) }\n"
      "light { type = directional  intensity = 1  direction = (3, 1, 0) }\n";
  const Scene valley = of(gable);
  const double offset = brightness(valley, SelfHit::offset), excluded = brightness(valley, SelfHit::exclusion);
  EXPECT_GT(offset, 0.01);
  EXPECT_NEAR(excluded, offset, 0.02 * offset);
}

// The story names the primitive that was left out, once for each ray that leaves a surface.
TEST(Exclusion, TheStoryNamesWhatWasNotTested) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings;
  settings.self_hit = SelfHit::exclusion;
  settings.accelerator = Accelerator::none;
  const PixelStory story = inspect(scene, {scene.camera, 60, 60}, settings, {30, 33});
  int excluded = 0, leaving = 0;
  for (const auto* ray : events_of<RayEvent>(story.events)) leaving += ray->kind != RayKind::eye;
  for (const auto* test : events_of<SphereTestEvent>(story.events)) excluded += test->outcome == TestOutcome::excluded;
  EXPECT_GT(leaving, 2);
  EXPECT_LE(excluded, leaving);
  EXPECT_GE(excluded, leaving / 2) << "an any-hit search may end before it reaches the surface";
}

}  // namespace
}  // namespace ps::exclusion_test
