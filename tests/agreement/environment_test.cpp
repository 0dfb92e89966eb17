// Environment maps against rays: what they hold, and how wrong they are where they are used.
#include <gtest/gtest.h>

#include <cmath>

#include "options/scene_settings.h"
#include "raster/maps.h"
#include "raster/shadow/cube_face.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::environment_test {
namespace {

constexpr int size = 200;

/// The room with its mirror ball moved, and the whole of it scaled but for the ball.
Scene room(const Vec3d& ball, double scale = 1) {
  Scene scene = load_scene("lab/mirror-room");
  scene.geometry.edit([&](Geometry& geometry) {
    for (Object& object : geometry.objects) {
      if (auto* sphere = std::get_if<Sphere>(&object.shape)) {
        sphere->centre = ball;
        continue;
      }
      Form& form = std::get<Solid>(object.shape).form;
      if (auto* rectangle = std::get_if<Rectangle>(&form)) {
        rectangle->corner *= scale;
        rectangle->side_a *= scale;
        rectangle->side_b *= scale;
      } else if (auto* cylinder = std::get_if<Cylinder>(&form)) {
        cylinder->from *= scale;
        cylinder->to *= scale;
        cylinder->radius *= scale;
      }
    }
  });
  scene.lights.edit([&](std::vector<Light>& lights) {
    for (Light& light : lights) light.position *= scale;
  });
  scene.camera.position = ball + Vec3d(0, 0.2, -2.6);
  return scene;
}

Frame draw(const Scene& scene, const Settings& settings, Renderer renderer) {
  Settings chosen = settings;
  chosen.renderer = renderer;
  chosen.shadows = Shadows::none;
  return render(scene, {scene.camera, size, size}, chosen, request_for(Channel::ids));
}

int mirror_of(const Scene& scene) {
  for (std::size_t i = 0; i < scene.geometry->objects.size(); ++i)
    if (std::holds_alternative<Sphere>(scene.geometry->objects[i].shape)) return static_cast<int>(i);
  return -1;
}

/// Root mean square difference from rays (levels of 255) over the mirror's pixels.
double error_on_mirror(const Scene& scene, Environment environment) {
  Settings settings = settings_for(scene);
  settings.reflection_depth = 1;
  settings.environment = environment;
  settings.environment_size = 256;
  const Frame traced = draw(scene, settings, Renderer::ray_tracer);
  const Frame drawn = draw(scene, settings, Renderer::rasterizer);
  const int mirror = mirror_of(scene);
  double sum = 0;
  int count = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      if (traced.ids.at(x, y).object != mirror || drawn.ids.at(x, y).object != mirror) continue;
      const Vec3f d = traced.colour.at(x, y) - drawn.colour.at(x, y);
      sum += (d.x * d.x + d.y * d.y + d.z * d.z) / 3;
      ++count;
    }
  EXPECT_GT(count, 2000);
  return 255 * std::sqrt(sum / count);
}

// One map for the whole room, made in its middle: the farther the ball moves away from there, the less it fits. A map
// of the ball's own moves with it.
TEST(Environment, ErrorGrowsAsTheObjectLeavesTheMapsCentre) {
  // The middle of what mirrors nothing is (0, 1, 0) times the scale.
  constexpr double scale = 10;
  std::vector<double> fixed, own;
  for (const double offset : {0.0, 1.0, 2.0, 4.0, 8.0}) {
    const Scene scene = room({0, scale, -offset}, scale);
    fixed.push_back(error_on_mirror(scene, Environment::room_map));
    own.push_back(error_on_mirror(scene, Environment::cube_map));
    std::printf("offset %.1f: room map %.2f, own map %.2f levels\n", offset, fixed.back(), own.back());
  }
  for (std::size_t i = 1; i < fixed.size(); ++i) EXPECT_GT(fixed[i], fixed[i - 1]);
  EXPECT_NEAR(fixed[0], own[0], 0.5) << "in the middle they are the same map";
  EXPECT_LT(own.back(), 0.8 * fixed.back());
}

// In a room ten times as large nothing that is mirrored is near, and the map is almost right (the book's spaceship).
TEST(Environment, ErrorVanishesInALargeRoom) {
  const double small = error_on_mirror(room({0, 1, 0}), Environment::cube_map);
  const double large = error_on_mirror(room({0, 10, 0}, 10), Environment::cube_map);
  const double none = error_on_mirror(room({0, 10, 0}, 10), Environment::none);
  std::printf("room %.2f, ten times as large %.2f, without a map %.2f levels\n", small, large, none);
  EXPECT_LT(large, 0.6 * small);
  EXPECT_GT(none, 3 * large);
}

// A map holds what rays from its centre find.
TEST(Environment, MapsHoldWhatRaysSee) {
  const Scene scene = room({0, 1, 0});
  Settings settings = settings_for(scene);
  settings.environment = Environment::room_map;
  settings.environment_size = 64;
  settings.shadows = Shadows::none;
  Prepared prepared;
  Progress progress;
  const auto maps = raster::environment_maps(scene, settings, prepared, WorkerPriority::normal, progress);
  const auto& map = (*maps)[static_cast<std::size_t>(mirror_of(scene))];
  ASSERT_TRUE(map);
  Scene empty = scene;
  empty.geometry.edit([&](Geometry& g) {
    std::erase_if(g.objects, [](const Object& o) { return std::holds_alternative<Sphere>(o.shape); });
  });
  Settings rays = settings_for(empty, Renderer::ray_tracer);
  rays.near = 1e-3;
  rays.shadows = Shadows::none;
  int wrong = 0;
  for (std::size_t face = 0; face < 6; ++face) {
    const View view{raster::cube_camera(raster::cube_faces()[face], map->centre), 64, 64};
    const Frame traced = render(empty, view, rays, {}, prepared, progress);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const Vec3f d = traced.colour.at(x, y) - map->faces[face].at(x, y);
        if (std::abs(d.x) + std::abs(d.y) + std::abs(d.z) > 0.05f) ++wrong;
      }
  }
  EXPECT_LT(wrong, 6 * 64 * 64 / 50) << "outlines of columns";
}

}  // namespace
}  // namespace ps::environment_test
