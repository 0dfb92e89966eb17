// Shadow volumes against what geometry says of them: closed surfaces, and outlines that can be counted by hand.
#include <gtest/gtest.h>

#include <map>

#include "raster/shadow/shadow_volume.h"
#include "scene/sphere_mesh.h"
#include "support/seeded_random.h"

namespace ps::shadow_volume_test {
namespace {

using raster::DrawObject;
using raster::make_shadow_volume;
using raster::ShadowVolume;

Light point_light(const Vec3d& position) {
  Light light{LightKind::point, 1};
  light.position = position;
  return light;
}

/// A cube from -1 to 1 with its faces outwards; `faces` of its twelve triangles.
DrawObject cube(std::size_t triangles = 12) {
  auto mesh = std::make_shared<Mesh>();
  for (int i = 0; i < 8; ++i) mesh->positions.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  const std::uint32_t quads[6][4]{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}};
  for (const auto& q : quads)
    for (const std::array<std::uint32_t, 3>& t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
      MeshTriangle triangle;
      triangle.position = t;
      mesh->triangles.push_back(triangle);
    }
  mesh->triangles.resize(triangles);
  DrawObject object;
  object.mesh = mesh;
  return object;
}

/// Is each edge run through as often one way as the other?
bool is_closed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const MeshTriangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t.position[k], b = t.position[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  return std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

/// Six times the volume that a closed surface encloses: positive if its triangles face outwards.
double signed_volume(const Mesh& mesh) {
  double sum = 0;
  for (const MeshTriangle& t : mesh.triangles)
    sum += dot(mesh.positions[t.position[0]], cross(mesh.positions[t.position[1]], mesh.positions[t.position[2]]));
  return sum;
}

TEST(ShadowVolume, ACubeShowsFourEdgesFromTheFrontAndSixFromACorner) {
  EXPECT_EQ(make_shadow_volume(cube(), point_light({0, 0, 5}), {.reach = 100}).silhouette.size(), 4u);
  EXPECT_EQ(make_shadow_volume(cube(), point_light({0, 4, 5}), {.reach = 100}).silhouette.size(), 6u);
  EXPECT_EQ(make_shadow_volume(cube(), point_light({5, 4, 6}), {.reach = 100}).silhouette.size(), 6u);
  Light sun{LightKind::directional, 1};
  sun.direction = {1, 2, 3};
  EXPECT_EQ(make_shadow_volume(cube(), sun, {.reach = 100}).silhouette.size(), 6u);
}

TEST(ShadowVolume, ALightInsideAClosedModelIsHiddenFromEverythingOutside) {
  const ShadowVolume volume = make_shadow_volume(cube(), point_light({0.1, 0.2, 0.3}), {.reach = 100});
  EXPECT_TRUE(volume.silhouette.empty());
  EXPECT_EQ(volume.surface->triangles.size(), 24u);
  EXPECT_GT(signed_volume(*volume.surface), 0);
}

TEST(ShadowVolume, IsClosedAndFacesOutwardsForClosedAndOpenModels) {
  test::SeededRandom random;
  DrawObject ball;
  ball.mesh = std::make_shared<const Mesh>(make_sphere_mesh(12));
  for (int i = 0; i < 200; ++i) {
    const Light light = point_light({random.between(-6, 6), random.between(-6, 6), random.between(-6, 6)});
    for (const DrawObject& object : {cube(), cube(7), cube(1), ball}) {
      const ShadowVolume volume = make_shadow_volume(object, light, {.reach = 50});
      ASSERT_TRUE(is_closed(*volume.surface));
      ASSERT_GT(signed_volume(*volume.surface), 0);
    }
  }
}

// Where two triangles of a model have corners of their own at the same place, they still share an edge.
TEST(ShadowVolume, WeldsCornersThatLieInOnePlace) {
  DrawObject object = cube();
  auto split = std::make_shared<Mesh>();
  for (const MeshTriangle& t : object.mesh->triangles) {
    MeshTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.position[k] = static_cast<std::uint32_t>(split->positions.size());
      split->positions.push_back(object.mesh->positions[t.position[k]]);
    }
    split->triangles.push_back(triangle);
  }
  object.mesh = split;
  EXPECT_EQ(make_shadow_volume(object, point_light({5, 4, 6}), {.reach = 100}).silhouette.size(), 6u);
}

double distance(const Vec3d& a, const Vec3d& b) { return std::sqrt(dot(a - b, a - b)); }

// The far corners lie the asked length away from the near ones, along the light, whatever its kind.
TEST(ShadowVolume, OfALengthReachesThatFar) {
  Light sun{LightKind::directional, 1};
  sun.direction = {1, 2, 3};
  for (const Light& light : {point_light({5, 4, 6}), sun}) {
    const ShadowVolume volume = make_shadow_volume(cube(), light, {.length = 2.5});
    const std::vector<Vec3d>& positions = volume.surface->positions;
    ASSERT_EQ(positions.size(), 16u);
    EXPECT_TRUE(is_closed(*volume.surface));
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3d towards = light.kind == LightKind::point ? light.position - positions[i] : light.direction;
      EXPECT_NEAR(distance(positions[i], positions[i + 8]), 2.5, 1e-12);
      EXPECT_NEAR(dot(positions[i] - positions[i + 8], towards), 2.5 * std::sqrt(dot(towards, towards)), 1e-12);
    }
  }
}

TEST(ShadowVolume, WithoutCapsHasItsSidesAlone) {
  const ShadowVolume closed = make_shadow_volume(cube(), point_light({5, 4, 6}), {.reach = 100});
  const ShadowVolume open = make_shadow_volume(cube(), point_light({5, 4, 6}), {.reach = 100, .caps = false});
  EXPECT_EQ(closed.caps, 12u);
  EXPECT_EQ(open.caps, 0u);
  EXPECT_EQ(open.surface->triangles.size(), closed.surface->triangles.size() - 12);
  EXPECT_EQ(open.surface->triangles.size(), 2 * open.silhouette.size());
  EXPECT_FALSE(is_closed(*open.surface));
}

}  // namespace
}  // namespace ps::shadow_volume_test
