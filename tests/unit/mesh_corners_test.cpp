#include "raster/setup/mesh_corners.h"

#include <gtest/gtest.h>

#include "scene/generate/torus_knot.h"

namespace ps::raster {
namespace mesh_corners_test {
namespace {

TEST(MeshCorners, AreThoseOfTheTriangles) {
  const Mesh mesh = make_torus_knot();
  const MeshCorners corners = make_mesh_corners(mesh);
  ASSERT_EQ(corners.positions.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) ASSERT_EQ(corners.positions[i], mesh.triangles[i].position);
  EXPECT_TRUE(corners.paired_normals);
  EXPECT_EQ(corners.heap_bytes(), 12 * mesh.triangles.size());
}

TEST(MeshCorners, ArePairedOnlyIfEveryCornerIs) {
  Mesh mesh = make_torus_knot();
  mesh.triangles.back().normal[2] = -1;
  EXPECT_FALSE(make_mesh_corners(mesh).paired_normals);
  mesh = make_torus_knot();
  std::swap(mesh.triangles.front().normal[0], mesh.triangles.front().normal[1]);
  EXPECT_FALSE(make_mesh_corners(mesh).paired_normals);
  mesh = make_torus_knot();
  mesh.normals.pop_back();
  EXPECT_FALSE(make_mesh_corners(mesh).paired_normals);
}

}  // namespace
}  // namespace mesh_corners_test
}  // namespace ps::raster
