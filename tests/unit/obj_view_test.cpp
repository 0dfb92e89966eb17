// The view of a model that comes without a camera: it shows what faces use, from a direction that shows area.
#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

#include "obj_corpus.h"

namespace ps::obj_view_test {
namespace {

/// A square of 2 in the plane of u and v, thickened by bumps of `height` along their normal.
std::string sheet(const Vec3d& u, const Vec3d& v, double height, bool reversed = false) {
  std::string text;
  constexpr int cells = 8;
  const Vec3d up = cross(u, v);
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const Vec3d p = (2.0 * i / cells - 1) * u + (2.0 * j / cells - 1) * v + ((i + j) % 2) * height * up;
      text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 1; i <= cells; ++i) {
      const int a = j * (cells + 1) + i;
      const int b = a + 1, c = a + cells + 2, d = a + cells + 1;
      text += reversed ? fmt::format("f {} {} {} {}\n", d, c, b, a) : fmt::format("f {} {} {} {}\n", a, b, c, d);
    }
  }
  return text;
}

/// Share of the viewport that the box around the projected vertices of faces covers.
double covered(const Scene& scene) {
  const Camera& camera = scene.camera;
  const Mesh& mesh = test::mesh_of(scene);
  double low_x = 1, high_x = -1, low_y = 1, high_y = -1;
  for (const MeshTriangle& triangle : mesh.triangles) {
    for (const std::uint32_t i : triangle.position) {
      const Vec3d seen = mesh.positions[i] - camera.position;
      const double depth = dot(seen, camera.forward);
      EXPECT_GT(depth, 0);
      const double x = dot(seen, camera.right) / depth * camera.projection_plane_d / (camera.viewport_width / 2);
      const double y = dot(seen, camera.up) / depth * camera.projection_plane_d / (camera.viewport_height / 2);
      low_x = std::min(low_x, x), high_x = std::max(high_x, x);
      low_y = std::min(low_y, y), high_y = std::max(high_y, y);
    }
  }
  EXPECT_GE(low_x, -1);
  EXPECT_LE(high_x, 1);
  EXPECT_GE(low_y, -1);
  EXPECT_LE(high_y, 1);
  return (high_x - low_x) * (high_y - low_y) / 4;
}

TEST(ObjView, FlatModelsAreSeenFromTheirFrontSide) {
  const test::ModelFolder folder;
  const double r = std::sqrt(0.5);
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (const auto& [u, v] : {std::pair{z, x},
                             {x, z},
                             {y, z},
                             {z, y},
                             {Vec3d{r, r, 0}, z},
                             {z, Vec3d{-r, r, 0}},
                             {Vec3d{0.8, 0, 0.6}, y},
                             {x, Vec3d{0, 0.05, -1}}}) {
    for (const double height : {0.0, 0.05}) {
      const Scene scene = folder.load(sheet(u, v, height));
      const Camera& camera = scene.camera;
      EXPECT_GT(covered(scene), 0.15);
      const Vec3d normal = cross(u, v);
      EXPECT_GT(-dot(camera.forward, normal), std::abs(dot(camera.forward, normal)) - 1e-12) << "its front";
      EXPECT_NEAR(dot(camera.right, camera.up), 0, 1e-12);
      EXPECT_NEAR(dot(cross(camera.right, camera.up), camera.forward), -1, 1e-12);
      EXPECT_TRUE(scene.warnings.empty());
    }
  }
}

TEST(ObjView, TilesAreSeenFromTheirFront) {
  const test::ModelFolder folder;
  for (const auto& [u, v] : {std::pair{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}}, {Vec3d{1, 0, 0}, Vec3d{0, 0.6, 0.8}}})
    EXPECT_EQ(folder.load(sheet(u, v, 0)).camera.forward, Vec3d(0, 0, -1));
}

TEST(ObjView, UnusedVerticesDoNotCount) {
  const test::ModelFolder folder;
  const std::string model = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\n", face = "f 1 2 3\n";
  const Scene clean = folder.load(model + face);
  for (const std::string stray : {"v 1000 0 0\n", "v 1000 0 0\np 4\n", "v 0 1e11 5\nl 1 4\n", "v nan 0 0\n"}) {
    const Scene scene = folder.load(model + stray + face);
    EXPECT_EQ(scene.camera.position, clean.camera.position) << stray;
    EXPECT_EQ(scene.camera.viewport_width, clean.camera.viewport_width) << stray;
  }
}

TEST(ObjView, AWordWhereNothingIsInView) {
  const test::ModelFolder folder;
  const auto warns = [&](const std::string& text, const std::string& part) {
    const Scene scene = folder.load(text);
    return scene.warnings.size() == 1 && scene.warnings[0].find(part) != std::string::npos;
  };
  EXPECT_TRUE(warns("v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n", "no triangle of the model has an area"));
  EXPECT_TRUE(warns("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", "no triangle of the model has an area"));
  // A pipe along z would show nothing but edges from its end.
  std::string pipe;
  for (int i = 0; i < 12; ++i)
    for (const int z : {-1, 1}) pipe += fmt::format("v {} {} {}\n", std::cos(0.5236 * i), std::sin(0.5236 * i), z);
  for (int i = 0; i < 12; ++i)
    pipe += fmt::format("f {} {} {} {}\n", 2 * i + 1, (2 * i + 2) % 24 + 1, (2 * i + 3) % 24 + 1, 2 * i + 2);
  EXPECT_TRUE(folder.load(pipe).warnings.empty());
  EXPECT_TRUE(warns("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 2 1\n", "the faces run clockwise"));
  const std::string cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
  EXPECT_TRUE(
      folder.load(cube + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n").warnings.empty());
  EXPECT_TRUE(
      warns(cube + "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n", "the faces run clockwise"));
}

}  // namespace
}  // namespace ps::obj_view_test
