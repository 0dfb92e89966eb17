// depth-value = ray-plane against the intersection of a ray and a plane in closed form, and its pictures against those
// of depths that are interpolated where that is right.
#include <gtest/gtest.h>

#include <glm/common.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "raster/base/depth_plane.h"
#include "render/story/story_tree.h"
#include "support/render_once.h"

namespace ps::depth_plane_test {
namespace {

constexpr int size = 64;
constexpr unsigned seed = 20150;

using Corners = std::array<Vec3d, 3>;

/// All numbers are floats, and the camera stands at the origin with the world's axes: camera space is world space.
Scene scene_of(const std::vector<Corners>& triangles) {
  Scene scene;
  auto mesh = std::make_shared<Mesh>();
  for (const Corners& corners : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh->positions.size());
    mesh->positions.insert(mesh->positions.end(), corners.begin(), corners.end());
    mesh->triangles.push_back({.position = {first, first + 1, first + 2}});
  }
  mesh->materials = {0};
  scene.materials.edit([](std::vector<Material>& m) { m.emplace_back(); });
  scene.geometry.edit([&](Geometry& g) {
    g.meshes.push_back(mesh);
    g.objects.push_back({"triangles", Instance{}});
  });
  return scene;
}

Corners random_triangle(std::mt19937& random, Projection projection) {
  std::uniform_real_distribution<double> place(-0.6, 0.6), depth(2, 20);
  Corners corners;
  for (Vec3d& c : corners) {
    const double z = depth(random), share = projection == Projection::perspective ? z : 1;
    c = Vec3d(Vec3f(Vec3d(place(random) * share, place(random) * share, z)));
  }
  return corners;
}

Settings settings_with(DepthValue value, Projection projection, Precision precision) {
  Settings settings{.renderer = Renderer::rasterizer};
  settings.lighting = false;
  settings.backface_culling = false;
  settings.depth_value = value;
  settings.projection = projection;
  settings.precision = precision;
  return settings;
}

/// Where on the plane z = 1 (or, if rays are parallel, z = 0) the place (x, y) of the picture lies, in pixels.
Vec2d on_plane(double x, double y) { return {(x - size / 2.0) / size, (size / 2.0 - y) / size}; }

Vec3d plane_normal(const Corners& c) { return cross(c[1] - c[0], c[2] - c[0]); }

double true_z(const Corners& c, const Vec2d& p, Projection projection) {
  const Vec3d n = plane_normal(c);
  if (projection == Projection::perspective) return dot(n, c[0]) / dot(n, Vec3d(p, 1));
  return (dot(n, c[0]) - n.x * p.x - n.y * p.y) / n.z;
}

/// How far rounding may move z, with `unit` half the distance from 1 to the next number: each component of the normal
/// is a difference of two products (error 4 units of their sizes), the plane's offset and the sum with the ray are sums
/// of three further products (5 more), and the ray's own direction has 2.
double rounding_of_z(const Corners& c, const Vec2d& p, Projection projection, double unit) {
  const Vec3d a = abs(c[1] - c[0]), b = abs(c[2] - c[0]), n = plane_normal(c);
  const Vec3d sizes(a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x);
  const double z = std::abs(true_z(c, p, projection));
  double above = 9 * unit * dot(sizes, abs(c[0])), below = 0, divisor = 0;
  if (projection == Projection::perspective) {
    below = 9 * unit * dot(sizes, abs(Vec3d(p, 1)));
    divisor = std::abs(dot(n, Vec3d(p, 1)));
  } else {
    above += 11 * unit * (sizes.x * std::abs(p.x) + sizes.y * std::abs(p.y));
    below = 4 * unit * sizes.z;
    divisor = std::abs(n.z);
  }
  if (!(divisor > 2 * below)) return std::numeric_limits<double>::infinity();
  return (above + z * below) / (divisor - below) + unit * z;
}

/// What the pixel's only fragment put into the depth test; of several samples the first.
std::optional<double> depth_at(const Scene& scene, const Settings& settings, Vec2i pixel) {
  const PixelStory story = inspect(scene, {scene.camera, size, size}, settings, pixel);
  for (const auto* fragment : events_of<FragmentEvent>(story.events))
    if (fragment->depth == FragmentEvent::Depth::passed && fragment->samples == fragment->samples_covered)
      return fragment->depth_new.value();
  return {};
}

class DepthPlane : public testing::TestWithParam<std::tuple<Projection, Precision, int>> {};

TEST_P(DepthPlane, IsWhereTheSamplesRayMeetsThePlane) {
  const auto& [projection, precision, samples] = GetParam();
  const double unit = precision == Precision::float32 ? 0x1p-24 : 0x1p-53;
  const Vec2d first = samples == 4 ? Vec2d(-2.0 / 16, -6.0 / 16) : Vec2d(0, 0);  // multisample.h
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  int read = 0, linear_off = 0;
  for (int i = 0; i < 40; ++i) {
    const Corners corners = random_triangle(random, projection);
    const Scene scene = scene_of({corners});
    const Vec3d inside = (corners[0] + corners[1] + corners[2]) / 3.0;
    const Vec2d seen = projection == Projection::perspective ? Vec2d(inside) / inside.z : Vec2d(inside);
    const Vec2i pixel(static_cast<int>((seen.x + 0.5) * size), static_cast<int>((0.5 - seen.y) * size));
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size || pixel.y >= size) continue;
    const Vec2d p = on_plane(pixel.x + 0.5 + first.x, pixel.y + 0.5 + first.y);
    const double truth = true_z(corners, p, projection);
    // The truth is rounded too, as a double.
    const double most = rounding_of_z(corners, p, projection, unit) + rounding_of_z(corners, p, projection, 0x1p-53);
    if (most > 1) continue;  // nearly edge-on: nothing would be proved
    Settings settings = settings_with(DepthValue::ray_plane, projection, precision);
    settings.multisampling = samples;
    const auto depth = depth_at(scene, settings, pixel);
    if (!depth) continue;  // too narrow to cover all samples
    ++read;
    EXPECT_NEAR(*depth, truth, most) << "triangle " << i;
    settings.depth_value = DepthValue::z;
    linear_off += std::abs(*depth_at(scene, settings, pixel) - truth) > most;
  }
  EXPECT_GT(read, 20);
  EXPECT_GT(linear_off, read / 2);  // rounded corners alone move an interpolated z by more
}

INSTANTIATE_TEST_SUITE_P(All, DepthPlane,
                         testing::Combine(testing::Values(Projection::perspective, Projection::orthographic),
                                          testing::Values(Precision::float32, Precision::float64),
                                          testing::Values(1, 4)));

/// How far moving each corner by half a sub-pixel step may move the interpolated value, which is affine on the canvas:
/// by its slope. 1 / z in perspective pictures, z in orthographic ones.
double snapping(const Corners& c, Projection projection) {
  constexpr double half_step = 1.0 / 512;  // subpixel-bits = 8
  const Vec3d n = plane_normal(c);
  const double across = (std::abs(n.x) + std::abs(n.y)) / size * half_step;
  return projection == Projection::perspective ? across / std::abs(dot(n, c[0])) : across / std::abs(n.z);
}

/// Pixels in which two pictures show different triangles that are not tied there.
int wrong_pixels(const std::vector<Corners>& triangles, const Frame& a, const Frame& b, Projection projection) {
  constexpr double rounding = 1e-9;
  int wrong = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      if (a.ids.at(x, y) == b.ids.at(x, y)) continue;
      const int of_a = a.ids.at(x, y).triangle, of_b = b.ids.at(x, y).triangle;
      if (of_a < 0 || of_b < 0) {
        ++wrong;
        continue;
      }
      double gap = 0, allowed = rounding;
      for (const int t : {of_a, of_b}) {
        const Corners& c = triangles[static_cast<std::size_t>(t)];
        const double z = true_z(c, on_plane(x + 0.5, y + 0.5), projection);
        gap = (projection == Projection::perspective ? 1 / z : z) - gap;
        allowed += snapping(c, projection);
      }
      wrong += std::abs(gap) > allowed;
    }
  return wrong;
}

TEST(DepthPlanePictures, EqualThoseOfDepthsThatAreLinearOnTheScreen) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    std::vector<Corners> triangles;
    triangles.reserve(60);
    for (int i = 0; i < 60; ++i) triangles.push_back(random_triangle(random, projection));
    const Scene scene = scene_of(triangles);
    const auto draw = [&](DepthValue value) {
      return render(scene, {scene.camera, size, size}, settings_with(value, projection, Precision::float64),
                    request_for(Channel::ids));
    };
    const bool perspective = projection == Projection::perspective;
    const Frame plane = draw(DepthValue::ray_plane);
    const Frame exact = draw(perspective ? DepthValue::inverse_z : DepthValue::z);
    EXPECT_EQ(wrong_pixels(triangles, plane, exact, projection), 0) << "perspective " << perspective;
    if (perspective) {
      EXPECT_GT(wrong_pixels(triangles, plane, draw(DepthValue::z), projection), 50);
    }
  }
}

/// Triangles whose plane goes through the eye: rounding alone gives them pixels, and rays run along them.
TEST(DepthPlanePictures, DrawTrianglesSeenEdgeOn) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.2, 0.8), aside(-0.05, 0.05);
  std::size_t drawn = 0;
  for (int i = 0; i < 40; ++i) {
    Corners c = random_triangle(random, Projection::perspective);
    c[2] = (c[0] * share(random) + c[1] * share(random)) + Vec3d(aside(random), aside(random), 0);
    const Scene scene = scene_of({c});
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      const auto draw = [&](DepthValue value) {
        return render(scene, {scene.camera, size, size}, settings_with(value, Projection::perspective, precision),
                      request_for(Channel::ids));
      };
      const Frame by_plane = draw(DepthValue::ray_plane), interpolated = draw(DepthValue::inverse_z);
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
          EXPECT_EQ(by_plane.ids.at(x, y), interpolated.ids.at(x, y)) << "triangle " << i << " at " << x << ", " << y;
          drawn += by_plane.ids.at(x, y).triangle >= 0;
        }
    }
  }
  EXPECT_GT(drawn, 100u);
  // A ray in the plane, and one beside it that meets it behind the eye.
  const auto plane = raster::make_depth_plane<float>({{{0, 0, 2}, {0, 0, 4}, {0, 1, 4}}}, {2, 4, 4});
  EXPECT_EQ(plane.along_eye_ray(0, 0.1f), 2);
  const auto slanted = raster::make_depth_plane<float>({{{1, 0, 2}, {1, 1, 2}, {1.5f, 0, 3}}}, {2, 2, 3});
  for (const float x : {0.25f, 0.5f, 0.75f, -1.0f}) {
    EXPECT_GE(slanted.along_eye_ray(x, 0.1f), 2);
    EXPECT_LE(slanted.along_eye_ray(x, 0.1f), 3);
  }
  // Sizes whose products no float holds.
  const auto huge = raster::make_depth_plane<float>({{{-1e15f, 0, 1e16f}, {1e15f, 0, 1e16f}, {0, 1e15f, 2e16f}}},
                                                    {1e16f, 1e16f, 2e16f});
  EXPECT_NEAR(huge.along_eye_ray(0, 0), 1e16f, 1e10f);
}

}  // namespace
}  // namespace ps::depth_plane_test
