// A convex polygon in space (LAB 4 projects one and fills it): what a scene file may say, and that it is drawn as the
// triangles around its first vertex.
#include <gtest/gtest.h>

#include <cmath>

#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"

namespace space_polygon_test {
namespace {

using namespace ps;

const std::string lights = "light { type = ambient intensity = 0.3 }\n"
                           "light { type = point intensity = 0.7 position = (1, 2, 0) }\n";

/// The message and the place of the error that a scene causes; an empty message if it is read.
struct Refusal {
  std::string message;
  int line = 0, column = 0;
};
Refusal refusal(const std::string& text) {
  try {
    parse_scene(text, "p.scene", ".");
  } catch (const InputError& error) {
    return {error.what(), error.place().line, error.place().column};
  }
  return {};
}

Frame drawn(const Scene& scene, Renderer renderer) {
  Settings settings = settings_for(scene);
  settings.renderer = renderer;
  settings.backface_culling = false;
  Prepared prepared;
  Progress progress;
  RenderRequest request;
  request.channels = Channel::ids;
  return render(scene, {scene.camera, 80, 60}, settings, request, prepared, progress);
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
  const Refusal bent = refusal("\npolygon { vertices = [(0, 0, 4), (1, 0, 4), (1, 1, 4.5), (0, 1, 4)] }");
  EXPECT_EQ(bent.line, 2);
  EXPECT_NE(bent.message.find("in the plane of the polygon"), std::string::npos) << bent.message;
  EXPECT_NE(bent.message.find("away"), std::string::npos) << bent.message;
  // Seven digits are enough to be flat.
  EXPECT_EQ(refusal("polygon { vertices = [(0.3333333, 0, 4), (1, 0, 4), (1, 1, 4.0000001), (0, 1, 4)] }").message, "");
  // One vertex far out of the plane of many is the one that is named: the third here.
  const Refusal spike = refusal("polygon { vertices = [(2, 0, 0),\n (1, 1, 0),\n  (0, 2, 0.5),\n (-2, 0, 0),\n"
                                " (-1, -1.5, 0),\n (0, -2, 0),\n (1, -1.5, 0)] }");
  EXPECT_EQ(spike.line, 3) << spike.message;
  EXPECT_EQ(spike.column, 3);
}

TEST(SpacePolygon, RefusesWhatIsNotConvexOrHasNoArea) {
  const Refusal dent = refusal("polygon { vertices = [(0, 0, 4), (2, 0, 4), (0.5, 0.5, 4), (0, 2, 4)] }");
  EXPECT_NE(dent.message.find("convex"), std::string::npos) << dent.message;
  EXPECT_EQ(dent.line, 1);
  EXPECT_EQ(dent.column, 22);
  EXPECT_NE(refusal("polygon { vertices = [(0, 10, 1), (6, -8, 1), (-10, 3, 1), (10, 3, 1), (-6, -8, 1)] }").message,
            "")
      << "a star, which goes round twice";
  EXPECT_NE(refusal("polygon { vertices = [(0, 0, 4), (1, 1, 4), (2, 2, 4)] }").message.find("area"),
            std::string::npos);
  EXPECT_NE(refusal("polygon { vertices = [(0, 0, 4), (1, 1, 4)] }").message, "");
  EXPECT_EQ(refusal("polygon { vertices = [(0, 0, 4), (1, 0, 4), (2, 0, 4), (2, 2, 4)] }").message, "")
      << "a vertex on an edge is no dent";
  EXPECT_NE(refusal("polygon { vertices = [(0, 0, 4), (1, 0), (2, 2, 4)] }").message, "") << "one vertex has two";
  EXPECT_NE(refusal("polygon { vertices = [(0, 0, 4), (1, 0, 4), (2, 2, 4)] h = [1, 1, 1] }").message.find('h'),
            std::string::npos)
      << "of the canvas alone";
}

}  // namespace
}  // namespace space_polygon_test
