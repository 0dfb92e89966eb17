#include <gtest/gtest.h>

#include <cmath>

#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/settings_with.h"
#include "support/trials.h"

namespace ps::useful_shadow_rays_test {
namespace {

constexpr int side = 101;

// A ball of radius 1, three units away, lit from the right and from behind. Where the eye ray of a pixel meets it, and
// which way the surface looks there, is worked out here in double.
Scene ball(const char* material) {
  return parse_scene(std::string("viewport_size = 1 x 1\nprojection_plane_d = 1\n"
                                 "light { type = directional intensity = 1 direction = (1, 0, 1) }\n"
                                 "sphere { center = (0, 0, 3) radius = 1 color = (255, 0, 0)") +
                         material + " }\n",
                     "ball.scene", "");
}

struct Point {
  bool hit = false;
  Vec3d normal{0, 0, 0}, to_eye{0, 0, 0};
};
Point point_at(int column, int row) {
  const Vec3d d((column + 0.5) / side - 0.5, 0.5 - (row + 0.5) / side, 1), centre(0, 0, 3);
  const double b = dot(d, centre), a = dot(d, d), discriminant = b * b - a * (dot(centre, centre) - 1);
  if (discriminant < 0) return {};
  return {true, d * ((b - std::sqrt(discriminant)) / a) - centre, -d};
}

std::uint64_t shadow_rays(const Scene& scene, ShadowRays which, Simd simd) {
  Settings settings;
  settings.shadow_rays = which;
  settings.simd = simd;
  return render(scene, {scene.camera, side, side}, settings).counters[Counter::shadow_rays];
}

TEST(UsefulShadowRays, LeaveFromWhereTheLightFalls) {
  const Vec3d to_light(1, 0, 1);
  std::uint64_t all = 0, facing = 0, shining = 0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const Point point = point_at(column, row);
      if (!point.hit) continue;
      const double cosine = dot(point.normal, to_light);
      const Vec3d mirrored = 2.0 * cosine * point.normal - to_light;
      ++all;
      facing += cosine > 0 ? 1 : 0;
      shining += cosine > 0 || dot(mirrored, point.to_eye) > 0 ? 1 : 0;
    }
  ASSERT_GT(shining, facing + 50);  // a highlight in the book does not ask from which side the light comes
  const Scene matte = ball(""), shiny = ball(" specular = 10");
  for (const Simd simd : {Simd::off, Simd::automatic}) {
    EXPECT_EQ(shadow_rays(matte, ShadowRays::all, simd), all);
    EXPECT_EQ(shadow_rays(matte, ShadowRays::useful, simd), facing);
    EXPECT_EQ(shadow_rays(shiny, ShadowRays::all, simd), all);
    EXPECT_EQ(shadow_rays(shiny, ShadowRays::useful, simd), shining);
  }
}

TEST(UsefulShadowRays, ChangeNoColour) {
  int fewer = 0, traced = 0;
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  for (std::size_t i = 0; i < scenes.size(); i += test::list_step) {
    SCOPED_TRACE(scenes[i].name);
    const Scene scene = load_scene(scenes[i].name);
    Settings settings = settings_for(scene, Renderer::ray_tracer);
    if (settings.shadows != Shadows::none) settings.shadows = Shadows::traced;
    const View view{scene.camera, 64, 48};
    const Frame all = render(scene, view, settings);
    settings.shadow_rays = ShadowRays::useful;
    const Frame useful = render(scene, view, settings);
    const auto a = all.colour.pixels(), b = useful.colour.pixels();
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    EXPECT_LE(useful.counters[Counter::shadow_rays], all.counters[Counter::shadow_rays]);
    traced += all.counters[Counter::shadow_rays] > 0 ? 1 : 0;
    fewer += useful.counters[Counter::shadow_rays] < all.counters[Counter::shadow_rays] ? 1 : 0;
  }
  EXPECT_GT(fewer, traced / 2);
}

}  // namespace
}  // namespace ps::useful_shadow_rays_test
