#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "scene/generate/displaced_sphere.h"
#include "scene/generate/teapot.h"
#include "scene/generate/torus_knot.h"
#include "scene/generate/uv_sphere.h"

namespace ps::generate_test {
namespace {

double length(const Vec3d& v) { return std::sqrt(dot(v, v)); }

/// How many triangles use each edge, in each of its two directions.
struct EdgeUse {
  int forward = 0, backward = 0;
};

std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> edges(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> found;
  for (const MeshTriangle& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle.position[k], b = triangle.position[(k + 1) % 3];
      EdgeUse& use = found[std::minmax(a, b)];
      ++(a < b ? use.forward : use.backward);
    }
  }
  return found;
}

/// Every edge belongs to two triangles that run along it in opposite directions; the Euler characteristic tells a
/// sphere (2) from a torus (0).
void expect_closed(const Mesh& mesh, int euler_characteristic) {
  const auto all = edges(mesh);
  for (const auto& [edge, use] : all) {
    ASSERT_EQ(use.forward, 1) << mesh.name << " edge " << edge.first << ' ' << edge.second;
    ASSERT_EQ(use.backward, 1) << mesh.name << " edge " << edge.first << ' ' << edge.second;
  }
  EXPECT_EQ(static_cast<int>(mesh.positions.size()) - static_cast<int>(all.size()) +
                static_cast<int>(mesh.triangles.size()),
            euler_characteristic);
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const MeshTriangle& t : mesh.triangles)
    sum += dot(mesh.positions[t.position[0]], cross(mesh.positions[t.position[1]], mesh.positions[t.position[2]])) / 6;
  return sum;
}

/// Vertex normals have unit length and lie on the front side of every triangle that uses them.
void expect_normals_outward(const Mesh& mesh) {
  for (const Vec3d& normal : mesh.normals) ASSERT_NEAR(length(normal), 1, 1e-12);
  for (const MeshTriangle& t : mesh.triangles) {
    const Vec3d& a = mesh.positions[t.position[0]];
    const Vec3d front = cross(mesh.positions[t.position[1]] - a, mesh.positions[t.position[2]] - a);
    ASSERT_GT(length(front), 0);
    for (const std::int32_t normal : t.normal)
      ASSERT_GT(dot(front, mesh.normals[static_cast<std::size_t>(normal)]), 0) << mesh.name;
  }
}

TEST(Generate, DisplacedSphereIsClosedWithTheExactCounts) {
  const Mesh mesh = make_displaced_sphere({.divisions = 40});
  EXPECT_EQ(mesh.triangles.size(), 12u * 40 * 40);
  expect_closed(mesh, 2);
  expect_normals_outward(mesh);
  EXPECT_EQ(make_displaced_sphere({.divisions = 129}).triangles.size(), 199692u);
}

TEST(Generate, DisplacedSphereNormalsMatchDifferencesOfTheSurface) {
  // The area-weighted mean of the triangles around a vertex tends to the normal of the smooth surface.
  const Mesh mesh = make_displaced_sphere({.divisions = 200});
  std::vector<Vec3d> mean(mesh.positions.size(), Vec3d{0, 0, 0});
  for (const MeshTriangle& t : mesh.triangles) {
    const Vec3d& a = mesh.positions[t.position[0]];
    const Vec3d front = cross(mesh.positions[t.position[1]] - a, mesh.positions[t.position[2]] - a);
    for (const std::uint32_t corner : t.position) mean[corner] += front;
  }
  for (std::size_t i = 0; i < mean.size(); ++i)
    ASSERT_GT(dot(mean[i] / length(mean[i]), mesh.normals[i]), std::cos(4 * std::numbers::pi / 180));
}

TEST(Generate, DisplacedSphereWithoutBumpsTendsToTheSphere) {
  const Mesh mesh = make_displaced_sphere({.divisions = 60, .amplitude = 0});
  EXPECT_NEAR(volume(mesh), 4 * std::numbers::pi / 3, 2e-3);
  for (const Vec3d& position : mesh.positions) ASSERT_NEAR(length(position), 1, 1e-12);
}

TEST(Generate, UvSphereIsClosedAndItsVolumeIsThatOfTheInscribedSolid) {
  const int slices = 24, stacks = 16;
  const Mesh mesh = make_uv_sphere({.slices = slices, .stacks = stacks});
  EXPECT_EQ(mesh.triangles.size(), 2u * slices * (stacks - 1));
  expect_closed(mesh, 2);
  expect_normals_outward(mesh);
  // A stack of frusta over regular polygons.
  double expected = 0;
  const double area = 0.5 * slices * std::sin(2 * std::numbers::pi / slices);
  for (int i = 0; i < stacks; ++i) {
    const double top = std::numbers::pi * i / stacks, bottom = std::numbers::pi * (i + 1) / stacks;
    const double a = std::sin(top), b = std::sin(bottom);
    expected += area * (std::cos(top) - std::cos(bottom)) * (a * a + a * b + b * b) / 3;
  }
  EXPECT_NEAR(volume(mesh), expected, 1e-12);
  for (const MeshTriangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2d uv = mesh.uvs[static_cast<std::size_t>(t.uv[k])];
      EXPECT_NEAR(std::cos(std::numbers::pi * uv.y), mesh.positions[t.position[k]].y, 1e-12);
    }
}

TEST(Generate, TorusKnotIsAClosedTubeOfTheRightVolume) {
  const TorusKnotOptions options{.segments = 600, .sides = 48};
  const Mesh mesh = make_torus_knot(options);
  EXPECT_EQ(mesh.triangles.size(), 2u * 600 * 48);
  expect_closed(mesh, 0);
  expect_normals_outward(mesh);
  // Pappus: cross section times length of the middle line.
  double line = 0;
  const int steps = 20000;
  const auto at = [&](int i) { return torus_knot_line(options, 2 * std::numbers::pi * i / steps); };
  for (int i = 0; i < steps; ++i) line += length(at(i + 1) - at(i));
  const double section = std::numbers::pi * options.tube_radius * options.tube_radius;
  EXPECT_NEAR(volume(mesh) / (section * line), 1, 0.01);
}

/// A patch's point by repeated linear interpolation (de Casteljau), independent of Bernstein polynomials.
Vec3d de_casteljau(std::array<Vec3d, 4> p, double t) {
  for (std::size_t left = 3; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  return p[0];
}
Vec3d de_casteljau(const BezierPatch& patch, double u, double v) {
  std::array<Vec3d, 4> column;
  for (std::size_t row = 0; row < 4; ++row)
    column[row] = de_casteljau(
        {patch.control[4 * row], patch.control[4 * row + 1], patch.control[4 * row + 2], patch.control[4 * row + 3]},
        u);
  return de_casteljau(column, v);
}

TEST(Teapot, ControlPointsAreThePublishedOnes) {
  const auto patches = teapot_patches();
  ASSERT_EQ(patches.size(), 32u);
  EXPECT_EQ(teapot_patches(TeapotBottom::open).size(), 28u);
  struct Published {
    std::size_t patch, point;
    Vec3d value;
  };
  // Patch and place in it (both from 0) with the numbers of the published table, some from every part.
  const std::vector<Published> published{{0, 1, {1.4, -0.784, 2.4}},
                                         {0, 6, {0.749, -1.3375, 2.53125}},
                                         {1, 9, {-0.805, -1.4375, 2.53125}},
                                         {2, 13, {-1.5, 0.84, 2.4}},
                                         {4, 5, {1.75, -0.98, 1.875}},
                                         {5, 10, {-2, -1.12, 1.35}},
                                         {7, 14, {2, 1.12, 0.9}},
                                         {8, 9, {1.5, -0.84, 0.225}},
                                         {10, 14, {-0.84, 1.5, 0.15}},
                                         {12, 2, {-1.5, -0.3, 2.25}},
                                         {13, 1, {-1.5, 0.3, 2.25}},
                                         {14, 9, {-2.5, -0.3, 1.125}},
                                         {15, 14, {-2, 0.3, 0.9}},
                                         {16, 6, {3.1, -0.66, 0.825}},
                                         {17, 9, {2.4, 0.25, 2.025}},
                                         {18, 10, {3.45, -0.15, 2.5125}},
                                         {19, 13, {3.2, 0.15, 2.4}},
                                         {20, 5, {0.8, -0.45, 3.15}},
                                         {21, 5, {-0.45, -0.8, 3.15}},
                                         {22, 8, {0, 0, 2.85}},
                                         {23, 14, {0.2, 0.112, 2.7}},
                                         {24, 9, {1.3, -0.728, 2.55}},
                                         {27, 6, {0.4, 0.224, 2.55}},
                                         {28, 5, {1.425, 0.798, 0}},
                                         {29, 10, {-1.5, 0.84, 0.075}},
                                         {31, 14, {1.5, -0.84, 0.15}}};
  for (const auto& [patch, point, value] : published)
    EXPECT_LT(length(patches[patch].control[point] - value), 1e-15) << patch << ' ' << point;
}

TEST(Teapot, TessellationAgreesWithDeCasteljauAndKeepsCorners) {
  for (const BezierPatch& patch : teapot_patches()) {
    for (const int row : {0, 3, 7})
      for (const int column : {0, 2, 7}) {
        const Vec3d point = patch_point(patch, {column, 7}, {row, 7});
        EXPECT_LT(length(point - de_casteljau(patch, column / 7.0, row / 7.0)), 1e-14);
      }
    EXPECT_EQ(patch_point(patch, {0, 7}, {0, 7}), patch.control[0]);
    EXPECT_EQ(patch_point(patch, {7, 7}, {0, 7}), patch.control[3]);
    EXPECT_EQ(patch_point(patch, {0, 7}, {7, 7}), patch.control[12]);
    EXPECT_EQ(patch_point(patch, {7, 7}, {7, 7}), patch.control[15]);
  }
}

TEST(Teapot, SeamsAreClosedAndOnlyTheSixOpenEdgesRemain) {
  for (const int n : {2, 3, 10, 16}) {
    const Mesh mesh = make_teapot({.divisions = n});
    EXPECT_EQ(static_cast<int>(mesh.triangles.size()), 64 * n * n - 8 * n);
    int open = 0;
    for (const auto& [edge, use] : edges(mesh)) {
      ASSERT_LE(use.forward, 1);
      ASSERT_LE(use.backward, 1);
      if (use.forward + use.backward == 1) ++open;
    }
    // Inside of the rim and edge of the lid, four patches each; both ends of handle and spout, two patches each.
    EXPECT_EQ(open, (4 + 4 + 2 + 2 + 2 + 2) * n) << "divisions " << n;
  }
}

TEST(Teapot, NormalsAreUnitAndPointOutwards) {
  const Mesh mesh = make_teapot();
  EXPECT_EQ(mesh.triangles.size(), 6320u);
  expect_normals_outward(mesh);
  const int body_first = 4 * 11 * 11, body_end = 12 * 11 * 11;  // normals of the body's patches
  for (const MeshTriangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d position = mesh.positions[t.position[k]];
      if (t.normal[k] < body_first || t.normal[k] >= body_end) continue;
      const Vec3d normal = mesh.normals[static_cast<std::size_t>(t.normal[k])];
      ASSERT_GT(position.x * normal.x + position.y * normal.y, 0);
    }
}

}  // namespace
}  // namespace ps::generate_test
