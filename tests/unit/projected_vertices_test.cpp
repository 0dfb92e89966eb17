// Vertices over the picture (CGPP 15.6.2): where they lie is computed by hand, and in the picture they lie at the
// corners of the drawn cube.
#include <gtest/gtest.h>

#include "image/file.h"
#include "inspect/vertex_chain.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/run_cli.h"

namespace ps::projected_vertices_test {
namespace {

constexpr const char* cube = "chapters/cgfs_09_perspective/cube.scene";

std::vector<ProjectedVertex> vertices_of(const char* name, std::size_t most = 1000) {
  const Scene scene = load_scene(name);
  return projected_vertices(scene, {scene.camera, scene.canvas_width, scene.canvas_height}, settings_for(scene), most);
}

/// The book's cube on a canvas of 600 pixels for one unit: 300 + 600 x / z from the left, 300 - 600 y / z from the top.
TEST(ProjectedVertices, LieWhereTheDivisionPutsThem) {
  const auto seen = vertices_of(cube);
  ASSERT_EQ(seen.size(), 8u);
  const Vec3d places[] = {{-2, -0.5, 5}, {-2, 0.5, 5}, {-1, 0.5, 5}, {-1, -0.5, 5},
                          {-2, -0.5, 6}, {-2, 0.5, 6}, {-1, 0.5, 6}, {-1, -0.5, 6}};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(seen[i].id, (VertexId{0, static_cast<int>(i)}));
    EXPECT_NEAR(seen[i].canvas.x, 300 + 600 * places[i].x / places[i].z, 1e-9);
    EXPECT_NEAR(seen[i].canvas.y, 300 - 600 * places[i].y / places[i].z, 1e-9);
    EXPECT_DOUBLE_EQ(seen[i].z, places[i].z);
  }
  EXPECT_EQ(vertices_of(cube, 3).size(), 3u);
}

/// Each is that of the panel Vertex; what lies behind the near limit or outside the picture is left out.
TEST(ProjectedVertices, AreThoseOfTheChain) {
  const Scene scene = load_scene("cgfs/behind");
  const View view{scene.camera, 300, 200};
  const Settings settings = settings_for(scene);
  const auto seen = projected_vertices(scene, view, settings, 10000);
  std::size_t expected = 0;
  const auto& objects = scene.geometry->objects;
  for (std::size_t object = 0; object < objects.size(); ++object) {
    const auto* instance = std::get_if<Instance>(&objects[object].shape);
    if (!instance) continue;
    const auto count = scene.geometry->meshes[instance->mesh]->positions.size();
    for (std::size_t vertex = 0; vertex < count; ++vertex) {
      const VertexChain chain =
          vertex_chain(scene, view, settings, {static_cast<int>(object), static_cast<int>(vertex)});
      const bool in_front = chain.camera.z >= settings.near * view.camera.projection_plane_d;
      const Vec2d at = chain.canvas;
      if (!in_front || at.x < 0 || at.y < 0 || at.x >= 300 || at.y >= 200) continue;
      ASSERT_LT(expected, seen.size());
      EXPECT_EQ(seen[expected].id, chain.id);
      EXPECT_NEAR(seen[expected].canvas.x, at.x, 1e-3);
      EXPECT_NEAR(seen[expected].canvas.y, at.y, 1e-3);
      ++expected;
    }
  }
  EXPECT_EQ(seen.size(), expected);
  EXPECT_GT(expected, 0u);
}

TEST(ProjectedVertices, AreMarkedInAPicture) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("cube.png");
  test::run_cli_well({"render", cube, "--mark-vertices", "--out", file});
  const Image<Rgb8> picture = load_levels(file);
  constexpr Rgb8 magenta{255, 0, 255};
  int marked = 0;
  for (const Rgb8& level : picture.pixels()) marked += level == magenta ? 1 : 0;
  EXPECT_EQ(marked, 8);
  EXPECT_EQ(picture.at(60, 360), magenta);   // (-2, -0.5, 5)
  EXPECT_EQ(picture.at(200, 250), magenta);  // (-1, 0.5, 6)
  EXPECT_NE(test::run_cli({"render", cube, "--mark-vertices", "--out", folder.file("cube.pfm")}).status, 0);
}

}  // namespace
}  // namespace ps::projected_vertices_test
