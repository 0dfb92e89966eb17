#include "raster/setup/tessellate.h"

#include <cmath>

#include <gtest/gtest.h>

#include "raster/setup/tessellate_solid.h"

namespace ps::raster {
namespace raster_tessellate_test {
namespace {

double length(const Vec3d& v) { return std::sqrt(dot(v, v)); }

TessellationView book_view(double max_error = 0.5) {
  Viewport<double> viewport;
  viewport.columns = viewport.rows = 600;
  viewport.span_x = viewport.span_y = 600;
  return make_tessellation_view(Camera{}, viewport, 1, max_error);
}

/// Largest distance between the triangles that face the eye and the sphere, in pixels as the book's camera sees it.
double worst_error(const Sphere& sphere, const Mesh& mesh) {
  double worst = 0;
  for (const MeshTriangle& t : mesh.triangles) {
    const Vec3d a = mesh.positions[t.position[0]], b = mesh.positions[t.position[1]], c = mesh.positions[t.position[2]];
    if (!(dot(-a, cross(b - a, c - a)) > 0)) continue;
    for (int i = 0; i <= 4; ++i)
      for (int k = 0; k + i <= 4; ++k) {
        const Vec3d p =
            (a * static_cast<double>(i) + b * static_cast<double>(k) + c * static_cast<double>(4 - i - k)) / 4.0;
        const double stray = sphere.radius - length(p - sphere.centre);
        if (length(p) < 1) continue;  // nearer than anything that is seen
        worst = std::max(worst, stray * 600 / length(p));
      }
  }
  return worst;
}

const Sphere red{{0, -1, 3}, 1, 0};
const Sphere ground{{0, -5001, 0}, 5000, 0};

TEST(Tessellation, StaysWithinTheAllowedErrorAndUsesMostOfIt) {
  for (const double error : {0.1, 0.5, 4.0})
    for (const Sphere& sphere : {red, ground, Sphere{{2, 0, 4}, 1, 0}, Sphere{{0, 0, 900}, 30, 0}}) {
      const Mesh mesh = tessellate_sphere(sphere, book_view(error));
      const double worst = worst_error(sphere, mesh);
      EXPECT_LE(worst, error) << "radius " << sphere.radius;
    }
  EXPECT_GT(worst_error(red, tessellate_sphere(red, book_view(4))), 0.5);
}

TEST(Tessellation, BookSceneTakesAtMost20000Triangles) {
  std::size_t triangles = 0;
  for (const Sphere& sphere : {red, Sphere{{-2, 0, 4}, 1, 0}, Sphere{{2, 0, 4}, 1, 0}, ground})
    triangles += tessellate_sphere(sphere, book_view()).triangles.size();
  EXPECT_LE(triangles, 20000u);
  EXPECT_GE(triangles, 2000u);
}

TEST(Tessellation, FacesOutwardsWithTheSpheresOwnNormals) {
  for (const Sphere& sphere : {red, ground}) {
    const Mesh mesh = tessellate_sphere(sphere, book_view());
    for (const MeshTriangle& t : mesh.triangles) {
      const Vec3d a = mesh.positions[t.position[0]];
      const Vec3d n = cross(mesh.positions[t.position[1]] - a, mesh.positions[t.position[2]] - a);
      EXPECT_GT(dot(n, a - sphere.centre), 0);
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      EXPECT_NEAR(length(mesh.normals[i]), 1, 1e-12);
      EXPECT_LT(length(mesh.positions[i] - sphere.centre - mesh.normals[i] * sphere.radius), 1e-8);
    }
  }
}

TEST(Tessellation, GroundReachesExactlyToTheHorizon) {
  const Mesh mesh = tessellate_sphere(ground, book_view());
  double highest = -1;
  for (const Vec3d& p : mesh.positions)
    if (p.z > 0) highest = std::max(highest, p.y / length(p));
  // The horizon dips by acos(r / D) below the level line.
  EXPECT_NEAR(std::asin(-highest), std::acos(5000.0 / 5001.0), 1e-9);
}

/// The rings of a plane grow by a factor until they reach the horizon, also from the least height that a double holds.
TEST(Tessellation, PlaneUnderTheSmallestHeightsEnds) {
  for (const double height : {5e-324, 1e-310, 1e-300, 1.0}) {
    TessellationView view;
    view.eye = {0, height, 0};
    view.nearest = 5e-324;
    const Mesh mesh = tessellate_solid(Solid{Plane{}}, view);
    EXPECT_GT(mesh.triangles.size(), 100u);
    EXPECT_LT(mesh.triangles.size(), 10000u);
  }
}

TEST(Tessellation, SurvivesOddViews) {
  for (const Sphere& sphere : {Sphere{{0, 0, 0}, 1, 0}, Sphere{{0, 0, 0.5}, 1, 0}, Sphere{{0, -1, 0}, 1, 0},
                               Sphere{{0, 0, 1e9}, 1e-6, 0}, Sphere{{0, 0, 5}, 1e8, 0}, Sphere{{0, 0, 5}, 1e-9, 0}}) {
    const Mesh mesh = tessellate_sphere(sphere, book_view());
    EXPECT_GE(mesh.triangles.size(), 6u);
    EXPECT_LE(mesh.triangles.size(), 600000u);
    for (const Vec3d& p : mesh.positions) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  TessellationView orthographic = book_view();
  orthographic.projection = Projection::orthographic;
  EXPECT_GE(tessellate_sphere(red, orthographic).triangles.size(), 100u);
}

}  // namespace
}  // namespace raster_tessellate_test
}  // namespace ps::raster
