// Shadow maps against closed forms and against rays: what a map holds, and what bias does to it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "raster/maps.h"
#include "raster/shadow/shadow_lookup.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::shadow_map_test {
namespace {

using raster::ShadowComparison;
using raster::ShadowMap;

constexpr double ball_radius = 0.5;
const Vec3d ball_centre{0, ball_radius, 0};

/// A ball on a floor, with the sun at an elevation.
Scene ball_on_floor(double elevation_degrees) {
  Scene scene;
  scene.materials = Part<std::vector<Material>>({Material{}});
  Geometry geometry;
  geometry.objects.push_back({"floor", Solid{Rectangle{{-4, 0, -4}, {0, 0, 8}, {8, 0, 0}}, 0}});
  geometry.objects.push_back({"ball", Sphere{ball_centre, ball_radius, 0}});
  scene.geometry = Part<Geometry>(std::move(geometry));
  const double angle = elevation_degrees * std::numbers::pi / 180;
  Light sun{LightKind::directional, 1};
  sun.direction = {0, std::sin(angle), std::cos(angle)};
  scene.lights = Part<std::vector<Light>>({sun});
  return scene;
}

ShadowMap map_of(const Scene& scene, int size) {
  Settings settings;
  settings.shadow_map_size = size;
  settings.tessellation = 0.05;
  Prepared prepared;
  Progress progress;
  return raster::shadow_maps(scene, settings, prepared, WorkerPriority::normal, progress)->front();
}

double texel(const ShadowMap& map) { return 2 * map.half / map.size; }

/// How far the sun's ray from a point passes by the middle of the ball; infinity behind it.
double distance_to_ball(const Vec3d& point, const Vec3d& to_sun) {
  const Vec3d across = ball_centre - point;
  const double along = dot(across, to_sun);
  const Vec3d rest = across - to_sun * along;
  return along < 0 ? std::numeric_limits<double>::infinity() : std::sqrt(dot(rest, rest));
}

double seen(const ShadowMap& map, const Vec3d& point, const ShadowComparison<double>& how) {
  Silent nobody;
  return raster::look_up_shadow(map, 0, point, Vec3d(0, 1, 0), how, nobody);
}

/// Mean darkness (%) of floor that the sun reaches.
double acne(const Scene& scene, const ShadowMap& map, const ShadowComparison<double>& how) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> any(-3.5, 3.5);
  const Vec3d to_sun = scene.lights->front().direction;
  double dark = 0;
  int lit = 0;
  while (lit < 20000) {
    const Vec3d point{any(random), 0, any(random)};
    if (distance_to_ball(point, to_sun) < ball_radius + 12 * texel(map)) continue;
    ++lit;
    dark += 1 - seen(map, point, how);
  }
  return 100 * dark / lit;
}

// A texel's depth is right in its middle; across half of it the floor lies farther from the sun than stored. What the
// bias does not cover of that half is dark.
TEST(ShadowMap, AcneFollowsTheClosedForm) {
  for (const double elevation : {60.0, 30.0, 10.0}) {
    const Scene scene = ball_on_floor(elevation);
    const double slope = 1 / std::tan(elevation * std::numbers::pi / 180);
    for (const int size : {256, 1024}) {
      const ShadowMap map = map_of(scene, size);
      for (const double bias : {0.0, 0.001, 0.01, 0.05}) {
        const double expected = 100 * std::max(0.0, 0.5 - bias / (texel(map) * slope));
        EXPECT_NEAR(acne(scene, map, {bias, 0, 1}), expected, 1.5) << elevation << " degrees, " << size << ", " << bias;
      }
      EXPECT_LT(acne(scene, map, {0, 0.52, 1}), 0.1) << "half a texel of slope";
      EXPECT_GT(acne(scene, map, {0, 0.4, 1}), 5) << "less than half";
    }
  }
}

// With a bias of one texel's slope: of three taps in a column one is dark half the time, of five one and a half.
TEST(ShadowMap, WiderFiltersNeedMoreBias) {
  const Scene scene = ball_on_floor(30);
  const ShadowMap map = map_of(scene, 512);
  EXPECT_LT(acne(scene, map, {0, 1, 1}), 0.1);
  EXPECT_NEAR(acne(scene, map, {0, 1, 3}), 100.0 / 6, 1);
  EXPECT_NEAR(acne(scene, map, {0, 1, 5}), 30, 1);
  EXPECT_LT(acne(scene, map, {0, 2.6, 5}), 0.1);
}

/// The share (%) of the shadow right under the ball that is lost, and the share of which the ball's lit side is so near
/// along the light that a constant bias must lose it.
struct Contact {
  double lost = 0, near = 0;
};
Contact contact(const Scene& scene, const ShadowMap& map, const ShadowComparison<double>& how) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> any(-0.15, 0.15);
  const Vec3d to_sun = scene.lights->front().direction;
  Contact contact;
  int shadowed = 0;
  while (shadowed < 5000) {
    const Vec3d point{any(random), 0, any(random)};
    if (!(point.x * point.x + point.z * point.z < 0.15 * 0.15) || distance_to_ball(point, to_sun) > ball_radius)
      continue;
    ++shadowed;
    contact.lost += seen(map, point, how);
    const double passes = distance_to_ball(point, to_sun);
    const double to_lit_side =
        dot(ball_centre - point, to_sun) + std::sqrt(ball_radius * ball_radius - passes * passes);
    if (to_lit_side < how.bias) contact.near += 1;
  }
  return {100 * contact.lost / shadowed, 100 * contact.near / shadowed};
}

TEST(ShadowMap, ALargeBiasTakesTheShadowOffTheBall) {
  const Scene scene = ball_on_floor(10);
  const ShadowMap map = map_of(scene, 2048);
  EXPECT_LT(contact(scene, map, {0, 0.52, 1}).lost, 3);
  double before = 0;
  for (const double bias : {0.1, 0.2, 0.4}) {
    const Contact found = contact(scene, map, {bias, 0, 1});
    EXPECT_NEAR(found.lost, found.near, 3) << bias;
    EXPECT_GT(found.lost, before + 3);
    before = found.lost;
  }
}

// What a face of a cube holds is what rays from the light find, within the error of tessellated spheres.
TEST(ShadowMap, HoldsTheDepthThatRaysFind) {
  const Scene scene = load_scene("cgfs/shadows");
  Settings settings;
  settings.shadow_map_size = 128;
  Prepared prepared;
  Progress progress;
  const auto maps = raster::shadow_maps(scene, settings, prepared, WorkerPriority::normal, progress);
  ASSERT_EQ(maps->size(), 3u);
  EXPECT_EQ((*maps)[0].size, 0) << "ambient light";
  const ShadowMap& cube = (*maps)[1];
  ASSERT_EQ(cube.faces.size(), 6u);
  int compared = 0, wrong = 0;
  for (std::size_t face = 0; face < 6; ++face) {
    Settings rays;
    rays.near = 1e-3;
    rays.lighting = false;
    rays.reflection_depth = 0;
    const View view{raster::cube_camera(raster::cube_faces()[face], cube.position), 128, 128};
    const Frame traced = render(scene, view, rays, request_for(Channel::depth), prepared, progress);
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) {
        const float a = cube.faces[face].at(x, y), b = traced.depth.at(x, y);
        if (!(b < 20)) continue;  // towards the horizon the ground runs along the ray
        ++compared;
        if (!(std::abs(a - b) < 0.02f * b)) ++wrong;
      }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_LT(wrong, compared / 100) << "outlines";
}

// A point is found on the face and texel through which its direction goes, and from there leads back to it.
TEST(ShadowMap, PlacesOnACubeLeadBackToTheirDirection) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 10000; ++i) {
    const Vec3d direction{any(random), any(random), any(random)};
    const int number = raster::cube_face_of(direction);
    const raster::CubeFace& face = raster::cube_faces()[static_cast<std::size_t>(number)];
    const Vec2d place = raster::face_position(raster::in_face(face, direction), 64);
    ASSERT_GE(std::min(place.x, place.y), -1e-9);
    ASSERT_LE(std::max(place.x, place.y), 64 + 1e-9);
    const Vec3d local = raster::face_direction(place, 64);
    const Vec3d back = face.right * local.x + face.up * local.y + face.forward * local.z;
    const Vec3d off = cross(back, direction);
    ASSERT_LT(std::sqrt(dot(off, off)), 1e-12);
    ASSERT_GT(dot(back, direction), 0);
  }
}

}  // namespace
}  // namespace ps::shadow_map_test
