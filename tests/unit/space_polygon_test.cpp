// A convex polygon in space (LAB 4 projects one and fills it): what a scene file may say, and that it is drawn as the
// triangles around its first vertex.
#include <gtest/gtest.h>

#include <cmath>

#include "options/scene_settings.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"
#include "support/refusal.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::space_polygon_test {
namespace {

const std::string lights = "light { type = ambient intensity = 0.3 }\n"
                           "light { type = point intensity = 0.7 position = (1, 2, 0) }\n";

/// The message that a scene causes, with its place; empty if it is read.
std::string refusal(const std::string& text) {
  return test::refusal_of([&] { parse_scene(text, "p.scene", "."); });
}

Frame drawn(const Scene& scene, Renderer renderer) {
  Settings settings = settings_for(scene, renderer);
  settings.backface_culling = false;
  return render(scene, {scene.camera, 80, 60}, settings, request_for(Channel::ids));
}

TEST(SpacePolygon, IsDrawnAsTheTrianglesAroundItsFirstVertex) {
  // A regular pentagon in a tilted plane, and the same as a model.
  std::string vertices, block;
  for (int i = 0; i < 5; ++i) {
    const double angle = 6.283185307179586 * i / 5, x = std::cos(angle), y = std::sin(angle);
    const std::string one =
        "(" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(4 + 0.5 * x - 0.25 * y) + ")";
    vertices += (i == 0 ? "" : ", ") + one;
    block += one + " ";
  }
  const std::string surface = "color = (200, 120, 40) specular = 30";
  const Scene polygon = parse_scene(
      lights + "polygon { name = P vertices = [" + vertices + "] " + surface + " sides = two }\n", "p.scene", ".");
  const Scene model =
      parse_scene(lights + "model { name = M vertices { " + block + "} triangles { (0, 1, 2) (0, 2, 3) (0, 3, 4) } " +
                      surface + " }\ninstance { model = M sides = two }\n",
                  "m.scene", ".");
  ASSERT_EQ(polygon.geometry->objects.size(), 1u);
  EXPECT_EQ(polygon.geometry->objects[0].name, "P");
  EXPECT_EQ(polygon.geometry->meshes.at(0)->triangles.size(), 3u);
  const Scene again = parse_scene(write_scene(polygon, "."), "again.scene", ".");
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    const Frame a = drawn(polygon, renderer), b = drawn(model, renderer);
    EXPECT_TRUE(a.colour == b.colour);
    EXPECT_TRUE(a.colour == drawn(again, renderer).colour) << "written and read back";
    int seen = 0;
    for (const PixelId& id : a.ids.pixels()) seen += id.object == 0 ? 1 : 0;
    EXPECT_GT(seen, 300);
  }
}

TEST(SpacePolygon, RefusesWhatIsNotFlatAtTheVertexThatLeavesThePlane) {
  const std::string bent = refusal("\npolygon { vertices = [(0, 0, 4), (1, 0, 4), (1, 1, 4.5), (0, 1, 4)] }");
  EXPECT_TRUE(bent.starts_with("p.scene:2:")) << bent;
  EXPECT_NE(bent.find("in the plane of the polygon"), std::string::npos) << bent;
  EXPECT_NE(bent.find("away"), std::string::npos) << bent;
  // Seven digits are enough to be flat.
  EXPECT_EQ(refusal("polygon { vertices = [(0.3333333, 0, 4), (1, 0, 4), (1, 1, 4.0000001), (0, 1, 4)] }"), "");
  // One vertex far out of the plane of many is the one that is named: the third here.
  const std::string spike = refusal("polygon { vertices = [(2, 0, 0),\n (1, 1, 0),\n  (0, 2, 0.5),\n (-2, 0, 0),\n"
                                    " (-1, -1.5, 0),\n (0, -2, 0),\n (1, -1.5, 0)] }");
  EXPECT_TRUE(spike.starts_with("p.scene:3:3: ")) << spike;
}

TEST(SpacePolygon, RefusesWhatIsNotConvexOrHasNoArea) {
  const std::string dent = refusal("polygon { vertices = [(0, 0, 4), (2, 0, 4), (0.5, 0.5, 4), (0, 2, 4)] }");
  EXPECT_NE(dent.find("convex"), std::string::npos) << dent;
  EXPECT_TRUE(dent.starts_with("p.scene:1:22: ")) << dent;
  EXPECT_NE(refusal("polygon { vertices = [(0, 10, 1), (6, -8, 1), (-10, 3, 1), (10, 3, 1), (-6, -8, 1)] }"), "")
      << "a star, which goes round twice";
  EXPECT_NE(refusal("polygon { vertices = [(0, 0, 4), (1, 1, 4), (2, 2, 4)] }").find("area"), std::string::npos);
  EXPECT_NE(refusal("polygon { vertices = [(0, 0, 4), (1, 1, 4)] }"), "");
  EXPECT_EQ(refusal("polygon { vertices = [(0, 0, 4), (1, 0, 4), (2, 0, 4), (2, 2, 4)] }"), "")
      << "a vertex on an edge is no dent";
  EXPECT_NE(refusal("polygon { vertices = [(0, 0, 4), (1, 0), (2, 2, 4)] }"), "") << "one vertex has two";
  EXPECT_NE(refusal("polygon { vertices = [(0, 0, 4), (1, 0, 4), (2, 2, 4)] h = [1, 1, 1] }").find('h'),
            std::string::npos)
      << "of the canvas alone";
}

}  // namespace
}  // namespace ps::space_polygon_test
