// Bump and normal maps of MTL files: heights in grey become normals, directions stay as they are.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/load.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"
#include "support/run_cli.h"

namespace ps::obj_relief_test {
namespace {

constexpr const char* quad = R"(mtllib quad.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl skin
f 1/1 2/2 3/3 4/4
)";
// Four texels from black to white, and one of a tilted normal.
constexpr const char* ramp = "P3\n4 1\n255\n0 0 0  85 85 85  170 170 170  255 255 255\n";
constexpr const char* tilted = "P3\n1 1\n255\n255 128 128\n";

Scene with_materials(const test::ScratchFolder& folder, const std::string& statements) {
  folder.write("ramp.ppm", ramp);
  folder.write("tilted.ppm", tilted);
  folder.write("quad.mtl", "newmtl skin\nKd 1 1 1\n" + statements);
  return load_scene(folder.write("quad.obj", quad));
}

const Texture& relief_of(const Scene& scene) {
  const int index = scene.materials->at(0).normal_map;
  EXPECT_GE(index, 0);
  return scene.textures->at(static_cast<std::size_t>(std::max(index, 0)));
}

TEST(ObjRelief, HeightsBecomeNormals) {
  const test::ScratchFolder folder;
  for (const double bump : {1.0, 0.5}) {
    const Scene scene = with_materials(folder, "map_Bump -bm " + std::to_string(bump) + " ramp.ppm\n");
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
    const Vec3f got = relief_of(scene).texels->at(1, 0) * 2.0f - Vec3f(1);
    const double slope = bump * 8 / 3;  // a third of white for each texel
    const double length = std::sqrt(1 + slope * slope);
    EXPECT_NEAR(got.x, -slope / length, 1e-5);
    EXPECT_NEAR(got.y, 0, 1e-6);
    EXPECT_NEAR(got.z, 1 / length, 1e-5);
  }
}

TEST(ObjRelief, DirectionsStayAndWin) {
  const test::ScratchFolder folder;
  for (const char* statements : {"norm tilted.ppm\n", "bump tilted.ppm\n", "map_bump ramp.ppm\nnorm tilted.ppm\n",
                                 "norm tilted.ppm\nmap_Bump ramp.ppm\n"}) {
    const Scene scene = with_materials(folder, statements);
    EXPECT_EQ(relief_of(scene).texels->at(0, 0), Vec3f(1, 128 / 255.0f, 128 / 255.0f)) << statements;
  }
}

TEST(ObjRelief, AMissingMapIsReportedAndLeftOut) {
  const test::ScratchFolder folder;
  const Scene scene = with_materials(folder, "norm nowhere.png\n");
  EXPECT_EQ(scene.materials->at(0).normal_map, -1);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("nowhere.png"), std::string::npos);
}

TEST(SceneHeights, ReadAndWritten) {
  const test::ScratchFolder folder;
  folder.write("ramp.ppm", ramp);
  const std::string file =
      folder.write("ball.scene", "texture { name = dents  file = \"ramp.ppm\"  heights = 3 }\n"
                                 "sphere { center = (0, 0, 3) radius = 1 color = white normal_map = dents }\n");
  const Scene scene = load_scene(file);
  const double slope = 3.0 / 3, length = std::sqrt(1 + slope * slope);
  EXPECT_NEAR(relief_of(scene).texels->at(1, 0).x * 2 - 1, -slope / length, 1e-5);
  const std::string again = write_scene(scene, folder.file("."));
  EXPECT_NE(again.find("heights = 3"), std::string::npos) << again;
  const Scene read = parse_scene(again, "again.scene", folder.file("."));
  EXPECT_TRUE(*relief_of(read).texels == *relief_of(scene).texels);
}

}  // namespace
}  // namespace ps::obj_relief_test
