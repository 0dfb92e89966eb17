#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "image/file.h"
#include "obj_corpus.h"

namespace obj_load_test {
namespace {

using ps::test::mesh_of;
using ps::test::ModelFolder;
using Corners = std::array<std::uint32_t, 3>;

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

double signed_area(const ps::Mesh& mesh, const ps::MeshTriangle& triangle) {
  const auto& a = mesh.positions[triangle.position[0]];
  const auto& b = mesh.positions[triangle.position[1]];
  const auto& c = mesh.positions[triangle.position[2]];
  return ps::cross(b - a, c - a).z / 2;
}

TEST(ObjLoad, PlainTriangle) {
  const ModelFolder folder;
  const ps::Scene scene = folder.load(corners + "f 1 2 3\n");
  const ps::Mesh& mesh = mesh_of(scene);
  ASSERT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.triangles[0].position, (Corners{0, 1, 2}));
  EXPECT_EQ(mesh.triangles[0].normal[0], -1);
  EXPECT_EQ(mesh.triangles[0].uv[0], -1);
  EXPECT_EQ(mesh.positions[2], ps::Vec3d(0, 1, 0));
  EXPECT_EQ(ps::files_of(scene), std::vector<std::string>{(folder.path() / "model.obj").string()});
}

TEST(ObjLoad, AllFourIndexForms) {
  const ModelFolder folder;
  const ps::Scene scene = folder.load(corners + "vt 0.25 0.25\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\n"
                                                "f 1/1/1 2/1/1 3/1/1\n");
  const auto& triangles = mesh_of(scene).triangles;
  ASSERT_EQ(triangles.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const auto& triangle = triangles[static_cast<std::size_t>(i)];
    EXPECT_EQ(triangle.uv[2], i == 1 || i == 3 ? 0 : -1) << i;
    EXPECT_EQ(triangle.normal[2], i >= 2 ? 0 : -1) << i;
  }
  EXPECT_EQ(mesh_of(scene).uvs[0], ps::Vec2d(0.25, 0.75)) << "v counts from the top";
}

TEST(ObjLoad, NegativeIndicesCountBackFromWhereTheyStand) {
  const ModelFolder folder;
  const ps::Scene scene = folder.load(corners + "f -3 -2 -1\nv 5 5 5\nf -4 -3 -1\n");
  const auto& triangles = mesh_of(scene).triangles;
  ASSERT_EQ(triangles.size(), 2U);
  EXPECT_EQ(triangles[0].position, (Corners{0, 1, 2}));
  EXPECT_EQ(triangles[1].position, (Corners{0, 1, 3}));
}

TEST(ObjLoad, FacesMayComeBeforeTheirVertices) {
  const ModelFolder folder;
  const ps::Scene scene = folder.load("f 1 2 3 4\nv 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\n");
  const auto& mesh = mesh_of(scene);
  ASSERT_EQ(mesh.triangles.size(), 2U);
  // An arrowhead: cut through its inner corner, both halves face the viewer.
  for (const auto& triangle : mesh.triangles) EXPECT_DOUBLE_EQ(signed_area(mesh, triangle), 0.5);
}

TEST(ObjLoad, EveryLineEndReadsTheSame) {
  const ModelFolder folder;
  const ps::Scene unix_ends = folder.load(corners + "# a comment\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  for (const std::string end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : corners + "# a comment\nvn 0 0 1\nf 1//1 2//1 3//1") text += c == '\n' ? end : std::string{c};
    const ps::Scene scene = folder.load(text);  // and without a line end after the last line
    EXPECT_EQ(mesh_of(scene), mesh_of(unix_ends));
  }
}

TEST(ObjLoad, NumbersInEveryForm) {
  const ModelFolder folder;
  const ps::Scene scene = folder.load("v .5 5. -1e-2\nv +1 1E2 -.25\nv 1 0 0 1 0.5 0.5 0.5\nf 1 2 3\n");
  const auto& positions = mesh_of(scene).positions;
  EXPECT_DOUBLE_EQ(positions[0].x, 0.5);
  EXPECT_DOUBLE_EQ(positions[0].y, 5);
  EXPECT_DOUBLE_EQ(positions[0].z, -0.01);
  EXPECT_DOUBLE_EQ(positions[1].x, 1);
  EXPECT_DOUBLE_EQ(positions[1].y, 100);
  EXPECT_DOUBLE_EQ(positions[1].z, -0.25);
}

TEST(ObjLoad, CommentsBehindStatementsJoinedLinesAndByteOrderMark) {
  const ModelFolder folder;
  const ps::Scene scene = folder.load("\xEF\xBB\xBFv 0 0 0 # origin\nv 1 0 \\\n0\nv 0 1 0\nf 1 \\\r\n2 3 # all\n");
  ASSERT_EQ(mesh_of(scene).triangles.size(), 1U);
  EXPECT_EQ(mesh_of(scene).positions[1], ps::Vec3d(1, 0, 0));
}

TEST(ObjLoad, PolygonsKeepTheirArea) {
  const ModelFolder folder;
  // The letter L (6 corners, one of them reflex), area 3, and a convex pentagon, area 5 - 0.5.
  const ps::Scene scene = folder.load("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n"
                                      "v 5 0 0\nv 7 0 0\nv 7 2 0\nv 6 2.5 0\nv 5 2 0\nf -5 -4 -3 -2 -1\n");
  const auto& mesh = mesh_of(scene);
  ASSERT_EQ(mesh.triangles.size(), 4U + 3U);
  double l_area = 0, pentagon_area = 0;
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_GE(signed_area(mesh, mesh.triangles[i]), 0) << i;
    (i < 4 ? l_area : pentagon_area) += signed_area(mesh, mesh.triangles[i]);
  }
  EXPECT_DOUBLE_EQ(l_area, 3);
  EXPECT_DOUBLE_EQ(pentagon_area, 4.5);
}

TEST(ObjLoad, TinyPolygonsAreCutToo) {
  const ModelFolder folder;
  const ps::Scene scene = folder.load("v 0 0 0\nv 2e-9 0 0\nv 2e-9 1e-9 0\nv 1e-9 1e-9 0\nv 1e-9 2e-9 0\nv 0 2e-9 0\n"
                                      "f 1 2 3 4 5 6\n");
  double area = 0;
  for (const auto& triangle : mesh_of(scene).triangles) area += signed_area(mesh_of(scene), triangle);
  EXPECT_NEAR(area, 3e-18, 1e-30);
}

TEST(ObjLoad, SeveralMaterialsWithBlanksInTheirNames) {
  const ModelFolder folder;
  folder.write("my stuff.mtl", "newmtl shiny red\nKd 1 0 0\nKs 0.5 0.5 0.25\nNs 42\nillum 2\n\n"
                               "newmtl matte\nKa 0.1 0.2 0.3\nKd 0 0.5 0\nKs 1 1 1\nNs 10\nillum 1\n");
  const ps::Scene scene =
      folder.load("mtllib my stuff.mtl\n" + corners +
                  "usemtl shiny red\nf 1 2 3\nusemtl matte  \nf 1 2 3\nusemtl shiny red\nf 3 2 1\n");
  EXPECT_TRUE(scene.warnings.empty());
  const ps::Material& red = ps::material_of(scene, 0, 0);
  EXPECT_EQ(red.name, "shiny red");
  EXPECT_EQ(red.colour, ps::Vec3d(1, 0, 0));
  EXPECT_EQ(red.specular, 42);
  EXPECT_EQ(red.specular_colour, ps::Vec3d(0.5, 0.5, 0.25));
  const ps::Material& matte = ps::material_of(scene, 0, 1);
  EXPECT_EQ(matte.colour, ps::Vec3d(0, 0.5, 0));
  EXPECT_FALSE(matte.specular);
  ASSERT_TRUE(matte.ambient_colour);
  EXPECT_DOUBLE_EQ(matte.ambient_colour->y, 0.2);
  EXPECT_EQ(&ps::material_of(scene, 0, 2), &red);
  EXPECT_EQ(ps::files_of(scene).size(), 2U);
}

TEST(ObjLoad, MissingMaterialsAreWarnings) {
  const ModelFolder folder;
  const ps::Scene scene = folder.load("mtllib none.mtl\n" + corners + "usemtl gold\nf 1 2 3\n");
  ASSERT_EQ(scene.warnings.size(), 2U);
  EXPECT_NE(scene.warnings[0].find("model.obj:1: the material file 'none.mtl' is missing"), std::string::npos);
  EXPECT_NE(scene.warnings[1].find("model.obj:5: the material 'gold' is missing"), std::string::npos);
  EXPECT_EQ(ps::material_of(scene, 0, 0).colour, ps::Vec3d(0.8, 0.8, 0.8));
}

TEST(ObjLoad, TextureFromAnotherFolder) {
  const ModelFolder folder;
  folder.write("sub/a.mtl",
               "newmtl m\nmap_Kd -s 1 1 1 pic one.ppm\nnewmtl n\nKd 0.5 0.5 0.5\nmap_Kd C:\\art\\pic one.ppm\n");
  folder.write("sub/pic one.ppm", "P3\n2 1\n255\n255 0 0  0 0 255\n");
  const ps::Scene scene = folder.load("mtllib sub/a.mtl\n" + corners +
                                      "vt 0 0\nusemtl m\nf 1/1 2/1 3/1\n"
                                      "usemtl n\nf 1/1 2/1 3/1\n");
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.textures->size(), 1U) << "one picture for both";
  const ps::Texture& texture = scene.textures->at(0);
  EXPECT_EQ(texture.texels->at(1, 0), ps::Vec3f(0, 0, 1));
  EXPECT_EQ(ps::material_of(scene, 0, 0).texture, 0);
  EXPECT_EQ(ps::material_of(scene, 0, 0).colour, ps::Vec3d(1, 1, 1)) << "no Kd leaves the texels as they are";
  EXPECT_EQ(ps::material_of(scene, 0, 1).colour, ps::Vec3d(0.5, 0.5, 0.5));
}

TEST(ObjLoad, ZeroNormalsCountAsMissing) {
  const ModelFolder folder;
  const ps::Scene scene = folder.load(corners + "vn 0 0 0\nvn 0 0 1\nf 1//2 2//1 3//2\nf 1//2 2//2 3//2\n");
  EXPECT_EQ(mesh_of(scene).triangles[0].normal, (std::array<std::int32_t, 3>{-1, -1, -1}));
  EXPECT_EQ(mesh_of(scene).triangles[1].normal, (std::array<std::int32_t, 3>{1, 1, 1}));
}

TEST(ObjLoad, GroupsObjectsAndSmoothingAreNoObstacle) {
  const ModelFolder folder;
  const ps::Scene scene =
      folder.load("o two words\ng a b\ns off\n" + corners + "f 1 2 3\ng\ns 1\nl 1 2\np 1\nf 3 2 1\n");
  EXPECT_EQ(mesh_of(scene).triangles.size(), 2U);
}

/// From the front, the right and above, upright: the face on +z is the largest, and those on +x and +y are seen.
TEST(ObjLoad, IsFramedWholeFromThreeQuarters) {
  const ModelFolder folder;
  for (const std::string size : {"1e-6", "1", "1e6"}) {
    std::string text;
    for (const std::string x : {"-", ""})
      for (const std::string y : {"-", ""})
        for (const std::string z : {"-", ""}) text += fmt::format("v {}{} {}{} {}{}\n", x, size, y, size, z, size);
    const ps::Scene scene = folder.load(text + "f 1 2 3\nf 6 7 8\n");
    const ps::Camera& camera = scene.camera;
    const ps::Vec3d back = ps::Vec3d(0) - camera.forward;
    EXPECT_GT(back.z, back.x);
    EXPECT_GT(back.x, 0.3);
    EXPECT_GT(back.y, 0.3);
    EXPECT_NEAR(camera.right.y, 0, 1e-15) << "level";
    EXPECT_GT(camera.right.x, 0);
    EXPECT_NEAR(ps::dot(camera.up, back), 0, 1e-15);
    EXPECT_NEAR(ps::dot(camera.up, camera.right), 0, 1e-15);
    EXPECT_GT(camera.up.y, 0.8);
    double widest = 0;
    for (const auto& position : mesh_of(scene).positions) {
      const ps::Vec3d seen = position - camera.position;
      const double depth = ps::dot(seen, camera.forward);
      EXPECT_GT(depth, camera.projection_plane_d) << "behind the near limit";
      for (const ps::Vec3d& axis : {camera.right, camera.up})
        widest = std::max(widest, std::abs(ps::dot(seen, axis)) / depth);
    }
    widest *= camera.projection_plane_d / (camera.viewport_width / 2);
    EXPECT_LT(widest, 1) << "fits";
    EXPECT_GT(widest, 0.5) << "fills";
  }
}

// The shipped model: its own normals must agree with the facing of its triangles.
TEST(ObjLoad, TheDieFacesOutwards) {
  const ps::Scene scene = ps::load_scene("assets/models/die.obj");
  EXPECT_TRUE(scene.warnings.empty());
  const ps::Mesh& mesh = mesh_of(scene);
  EXPECT_EQ(mesh.triangles.size(), 6U * 8 * 8 * 2);
  for (const auto& triangle : mesh.triangles) {
    const auto& a = mesh.positions[triangle.position[0]];
    const ps::Vec3d facing =
        ps::cross(mesh.positions[triangle.position[1]] - a, mesh.positions[triangle.position[2]] - a);
    ASSERT_GT(ps::dot(facing, mesh.normals.at(static_cast<std::size_t>(triangle.normal[0]))), 0);
  }
  EXPECT_EQ(scene.textures->size(), 1U);
}

}  // namespace
}  // namespace obj_load_test
