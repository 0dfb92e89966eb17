#include "raster/base/clip.h"
#include "support/render_once.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "raster/setup/draw_list.h"

namespace ps::raster {
namespace raster_clip_test {
namespace {

ClipPolygon<double> triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  ClipPolygon<double> polygon;
  polygon.push({a, {1, 0, 0}});
  polygon.push({b, {0, 1, 0}});
  polygon.push({c, {0, 0, 1}});
  return polygon;
}

double area(const ClipPolygon<double>& p) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(p.size); ++i) {
    const Vec3d n =
        cross(p.corners[i].position - p.corners[0].position, p.corners[i + 1].position - p.corners[0].position);
    sum += std::sqrt(dot(n, n)) / 2;
  }
  return sum;
}

TEST(Clip, KeepsTheShareOfTheAreaThatGeometrySays) {
  // A plane through two sides at a third of the way from the apex keeps 1/9 of the triangle, and 8/9 from the other
  // side.
  const ClipPlane<double> above{{0, 1, 0}, -2, RejectReason::clipped_side, "above"};
  ClipPolygon<double> top = triangle({0, 3, 5}, {3, 0, 5}, {-3, 0, 5});
  EXPECT_EQ(clip_polygon(top, above), ClipOutcome::split);
  EXPECT_EQ(top.size, 3);
  EXPECT_NEAR(area(top), 1.0, 1e-12);
  const ClipPlane<double> below{{0, -1, 0}, 2, RejectReason::clipped_side, "below"};
  ClipPolygon<double> rest = triangle({0, 3, 5}, {3, 0, 5}, {-3, 0, 5});
  EXPECT_EQ(clip_polygon(rest, below), ClipOutcome::split);
  EXPECT_EQ(rest.size, 4);
  EXPECT_NEAR(area(rest), 8.0, 1e-12);
}

TEST(Clip, BothSidesOfAnyPlaneAddUpAndWeightsFollowPositions) {
  constexpr unsigned seed = 11;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> range(-5, 5);
  int split = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto point = [&] { return Vec3d(range(random), range(random), range(random)); };
    const Vec3d a = point(), b = point(), c = point();
    Vec3d normal = point();
    normal /= std::sqrt(dot(normal, normal));
    const double offset = range(random) / 3;
    ClipPolygon<double> front = triangle(a, b, c), back = triangle(a, b, c);
    const ClipOutcome outcome = clip_polygon(front, {normal, offset, RejectReason::clipped_side, "p"});
    const ClipOutcome opposite = clip_polygon(back, {-normal, -offset, RejectReason::clipped_side, "q"});
    if (outcome != ClipOutcome::split) {
      EXPECT_NE(opposite, ClipOutcome::split) << "seed " << seed << ", trial " << trial;
      continue;
    }
    ++split;
    EXPECT_NEAR(area(front) + area(back), area(triangle(a, b, c)), 1e-9) << "seed " << seed << ", trial " << trial;
    for (int i = 0; i < front.size; ++i) {
      const auto& corner = front.corners[static_cast<std::size_t>(i)];
      const Vec3d expected = a * corner.weights.x + b * corner.weights.y + c * corner.weights.z;
      const Vec3d off = expected - corner.position;
      EXPECT_LT(std::sqrt(dot(off, off)), 1e-12);
      EXPECT_GT(dot(normal, corner.position) + offset, -1e-12);
    }
  }
  EXPECT_GT(split, 300);
}

TEST(Clip, NeighboursGetTheSameCornerOnASharedEdge) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> range(-5, 5);
  int compared = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto point = [&] { return Vec3f(range(random), range(random), range(random)); };
    const Vec3f a = point(), b = point();
    const ClipPlane<float> plane{{0, 0, 1}, range(random) / 4, RejectReason::clipped_near, "near"};
    if ((plane.distance(a) >= 0) == (plane.distance(b) >= 0)) continue;
    const auto cut_corners = [&](const Vec3f& first, const Vec3f& second, const Vec3f& third) {
      ClipPolygon<float> polygon;
      for (const Vec3f& p : {first, second, third}) polygon.push({p, {}});
      clip_polygon(polygon, plane);
      std::vector<Vec3f> corners;
      corners.reserve(static_cast<std::size_t>(polygon.size));
      for (int i = 0; i < polygon.size; ++i) corners.push_back(polygon.corners[static_cast<std::size_t>(i)].position);
      return corners;
    };
    const auto left = cut_corners(a, b, point()), right = cut_corners(b, a, point());
    int shared = 0;
    for (const Vec3f& p : left)
      for (const Vec3f& q : right) shared += p == q;
    EXPECT_EQ(shared, 2) << "seed 5, trial " << trial;  // the inner end and the cut
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

Scene triangle_scene(std::vector<Vec3d> positions) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = std::move(positions);
  for (std::uint32_t i = 0; i + 2 < mesh->positions.size(); i += 3)
    mesh->triangles.push_back({.position = {i, i + 1, i + 2}});
  mesh->materials = {0};
  Scene scene;
  scene.background = {0, 0, 0};
  scene.materials.edit([](std::vector<Material>& m) { m.emplace_back(); });
  scene.geometry.edit([&](Geometry& g) {
    g.meshes.push_back(mesh);
    g.objects.push_back({"triangles", Instance{}});
  });
  return scene;
}

Frame draw(const Scene& scene, Settings settings, int size = 100) {
  settings.renderer = Renderer::rasterizer;
  settings.backface_culling = false;
  settings.lighting = false;
  return render(scene, {scene.camera, size, size}, settings);
}

std::int64_t white_pixels(const Frame& frame) {
  std::int64_t count = 0;
  for (const Vec3f& c : frame.colour.pixels()) count += c == Vec3f(1);
  return count;
}

/// A floor that runs from far ahead to far behind the camera covers exactly the lower half of the picture.
TEST(Clip, FloorThroughTheCameraCoversTheLowerHalf) {
  const Scene scene = triangle_scene({{-1e4, -1, 1e4}, {1e4, -1, 1e4}, {0, -1, -1e4}});
  Settings settings;
  for (const Clipping clipping : {Clipping::full, Clipping::near_only}) {
    settings.clipping = clipping;
    settings.near = 0.01;
    const Frame frame = draw(scene, settings);
    EXPECT_NEAR(static_cast<double>(white_pixels(frame)), 5000, 100);
    EXPECT_EQ(frame.counters[Counter::triangles_split], 1u);
  }
  settings.clipping = Clipping::none;  // stability.md row 36: a large part of the picture is wrong
  EXPECT_GT(std::abs(static_cast<double>(white_pixels(draw(scene, settings))) - 5000), 500);
}

TEST(Clip, StagesAreCounted) {
  Scene scene = triangle_scene({{-1, -1, 5},
                                {0, 1, 5},
                                {1, -1, 5},  // in view
                                {20, 0, 5},
                                {21, 0, 5},
                                {20, 1, 5},  // right of it
                                {-4, -1, 5},
                                {0, 1, 5},
                                {0, -1, 5},  // across the left plane
                                {0, 0, 5},
                                {1, 1, 5},
                                {2, 2, 5}});  // no area
  const Frame frame = draw(scene, {});
  EXPECT_EQ(frame.counters[Counter::triangles_in], 4u);
  EXPECT_EQ(frame.counters[Counter::triangles_clipped_away], 1u);
  EXPECT_EQ(frame.counters[Counter::triangles_split], 1u);
  EXPECT_EQ(frame.counters[Counter::triangles_degenerate], 1u);
  scene.geometry.edit([](Geometry& g) { std::get<Instance>(g.objects[0].shape).transform.translation = {0, 0, -50}; });
  const Frame behind = draw(scene, {});
  EXPECT_EQ(behind.counters[Counter::objects_culled], 1u);
  EXPECT_EQ(behind.counters[Counter::triangles_in], 0u);
}

/// Colours of the clipped picture equal those of the unclipped one: weights are carried through the cuts.
TEST(Clip, AttributesSurviveTheCut) {
  const Scene scene = triangle_scene({{-40, -3, 30}, {5, 2, 6}, {6, -30, 20}});
  Settings settings{.renderer = Renderer::rasterizer};
  settings.backface_culling = false;
  settings.lighting = false;
  const auto make = [&](Clipping clipping) {
    settings.clipping = clipping;
    return render(scene, {scene.camera, 200, 200}, settings, request_for(Channel::barycentric | Channel::depth));
  };
  const Frame full = make(Clipping::full), none = make(Clipping::none);
  EXPECT_EQ(full.counters[Counter::triangles_split], 1u);
  EXPECT_EQ(none.counters[Counter::triangles_split], 0u);
  int compared = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const Vec3f a = full.barycentric.at(x, y), b = none.barycentric.at(x, y);
      if (a == Vec3f(0) || b == Vec3f(0)) continue;
      ++compared;
      for (int i = 0; i < 3; ++i) ASSERT_NEAR(a[i], b[i], 2e-3) << x << ", " << y;
      ASSERT_NEAR(full.depth.at(x, y), none.depth.at(x, y), 0.05) << x << ", " << y;
    }
  EXPECT_GT(compared, 3000);
}

}  // namespace
}  // namespace raster_clip_test
}  // namespace ps::raster
