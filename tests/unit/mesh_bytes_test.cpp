// The bytes of meshes with and without shared vertices (CGPP 15.4), counted by hand.
#include "scene/mesh_bytes.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scene/generate/displaced_sphere.h"
#include "scene/load.h"
#include "support/run_cli.h"

namespace ps::mesh_bytes_test {
namespace {

TEST(MeshBytes, ACubeHasEightVertices) {
  const MeshBytes cube = bytes_of_meshes(load_scene("chapters/cgfs_09_perspective/cube.scene"));
  EXPECT_EQ(cube.triangles, 12u);
  EXPECT_EQ(cube.vertices, 8u);
  EXPECT_EQ(cube.shared, 8u * 12 + 12 * 12);  // three numbers a vertex, three indices a triangle
  EXPECT_EQ(cube.unshared, 36u * 12);
  EXPECT_EQ(mesh_bytes_text(cube), "8 vertices for 12 triangles: 240 bytes shared, 432 bytes unshared");
}

/// A closed surface of genus 0 with t triangles has t / 2 + 2 vertices (Euler), so a vertex of six numbers costs
/// 12 + 12 = 24 bytes a triangle shared, and 72 unshared.
TEST(MeshBytes, ALargeMeshSharesToAThird) {
  const MeshBytes sphere = bytes_of_mesh(make_displaced_sphere({.divisions = 40}));
  EXPECT_EQ(sphere.triangles, 12u * 40 * 40);
  EXPECT_EQ(sphere.vertices, sphere.triangles / 2 + 2);
  EXPECT_EQ(sphere.shared, 24 * sphere.triangles + 2 * 24);
  EXPECT_EQ(sphere.unshared, 72 * sphere.triangles);
}

/// A corner with two normals is two vertices, and a seam of a texture doubles those on it.
TEST(MeshBytes, VerticesThatDifferInAnAttributeAreTwo) {
  Mesh two;
  two.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  two.uvs = {{0, 0}, {1, 0}};
  two.triangles.resize(2);
  two.triangles[0].position = {0, 1, 2};
  two.triangles[1].position = {2, 1, 3};
  for (MeshTriangle& triangle : two.triangles) triangle.uv = {0, 0, 0};
  EXPECT_EQ(bytes_of_mesh(two).vertices, 4u);
  EXPECT_EQ(bytes_of_mesh(two).shared, 4u * 20 + 24);
  two.triangles[1].uv = {1, 1, 1};
  EXPECT_EQ(bytes_of_mesh(two).vertices, 6u);
  EXPECT_EQ(bytes_of_mesh(two).shared, 6u * 20 + 24);
  // Vertices 1 and 2, which both triangles share, have two normals each.
  two.uvs.clear();
  two.normals = {{0, 0, 1}, {0, 1, 0}};
  two.triangles[1].uv = {0, 0, 0};
  two.triangles[0].normal = {0, 0, 0};
  two.triangles[1].normal = {1, 1, 1};
  EXPECT_EQ(bytes_of_mesh(two).vertices, 6u);
  EXPECT_EQ(bytes_of_mesh(two).shared, 6u * 24 + 24);
  EXPECT_EQ(bytes_of_mesh(two).unshared, 6u * 24);
  EXPECT_EQ(bytes_of_mesh(Mesh{}).unshared, 0u);
  EXPECT_EQ(mesh_bytes_text({}), "");
  EXPECT_EQ(mesh_bytes_text({1280, 642, 15360, 46080}),
            "642 vertices for 1,280 triangles: 15,360 bytes shared, 46,080 bytes unshared");
}

TEST(MeshBytes, AModelCountsOnceHoweverManyInstances) {
  const Scene cubes = load_scene("cgfs/cubes");
  ASSERT_GT(cubes.geometry->objects.size(), cubes.geometry->meshes.size());
  EXPECT_EQ(bytes_of_meshes(cubes).triangles, 12u);
}

TEST(MeshBytes, CommandLineSaysThem) {
  const auto needs = test::run_cli_well({"needs", "cgfs/cubes", "--size", "24x24", "--repeats", "1", "--json"});
  const auto json = nlohmann::json::parse(needs.out);
  EXPECT_EQ(json["meshes"]["vertices"], 8);
  EXPECT_EQ(json["meshes"]["shared_bytes"], 240);
  EXPECT_EQ(json["meshes"]["unshared_bytes"], 432);
}

}  // namespace
}  // namespace ps::mesh_bytes_test
