// What the microscope has to say on a pixel without edges.
#include <gtest/gtest.h>

#include <cmath>

#include "inspect/microscope/microscope.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/scene_file.h"

namespace pixel_surroundings_test {
namespace {

using namespace ps;

constexpr int side = 100;

/// A wall with a square in front of it: the square's left edge lies between columns 49 and 50, its upper edge between
/// rows 39 and 40; a light beside the eye throws no shadow that is seen.
Scene wall_and_square() {
  return parse_scene("light { type = ambient intensity = 1 }\n"
                     "rectangle { name = wall corner = (-50, -50, 10) side_a = (100, 0, 0) side_b = (0, 100, 0) "
                     "color = white }\n"
                     "rectangle { name = square corner = (0, -0.4, 2) side_a = (0.9, 0, 0) side_b = (0, 0.6, 0) "
                     "color = red }\n",
                     "wall.scene", ".");
}

std::optional<PixelSurroundings> around(const Scene& scene, std::initializer_list<const char*> assignments,
                                        Vec2i pixel) {
  Settings settings = settings_for(scene);
  for (const char* one : assignments) parse_assignment(one, settings);
  Prepared prepared;
  Progress progress;
  const Microscope scope(scene, {scene.camera, side, side}, settings, pixel, prepared, progress);
  return scope.surroundings();
}

/// The nearest pixel with another object beside it, looked for in the whole picture.
double nearest_by_hand(const Scene& scene, Vec2i from) {
  Settings settings = settings_for(scene);
  settings.renderer = Renderer::ray_tracer;
  RenderRequest request;
  request.channels = Channel::ids;
  Prepared prepared;
  Progress progress;
  const Frame frame = render(scene, {scene.camera, side, side}, settings, request, prepared, progress);
  double least = 1e9;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (const Vec2i d : {Vec2i{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const Vec2i p = Vec2i{x, y} + d;
        if (p.x < 0 || p.y < 0 || p.x >= side || p.y >= side) continue;
        if (frame.ids.at(p.x, p.y).object != frame.ids.at(x, y).object)
          least = std::min(least, std::hypot(x - from.x, y - from.y));
      }
  return least;
}

TEST(PixelSurroundings, NameTheNeighboursAndTheNearestEdge) {
  const Scene scene = wall_and_square();
  for (const char* renderer : {"renderer=ray-tracer", "renderer=rasterizer"})
    for (const Vec2i pixel : {Vec2i{30, 55}, {47, 52}, {62, 50}}) {
      const auto found = around(scene, {renderer}, pixel);
      ASSERT_TRUE(found) << renderer;
      ASSERT_EQ(found->around.size(), 9u);
      EXPECT_EQ(found->around[4].pixel, pixel);
      ASSERT_TRUE(found->edge);
      const Vec2d away = Vec2d(found->edge->pixel - pixel);
      if (std::string(renderer) == "renderer=ray-tracer") {
        EXPECT_DOUBLE_EQ(std::hypot(away.x, away.y), nearest_by_hand(scene, pixel));
      }
      EXPECT_NE(found->edge->here, found->edge->beyond);
    }
  const auto on_wall = around(scene, {"renderer=ray-tracer"}, {30, 55});
  for (const SeenPixel& one : on_wall->around) EXPECT_EQ(one.seen, "wall");
  EXPECT_EQ(on_wall->edge->here, "wall");
  EXPECT_EQ(on_wall->edge->beyond, "square");
}

TEST(PixelSurroundings, ThereAreNoneWhereAnEdgeIsSeen) {
  const Scene scene = wall_and_square();
  // The picture's middle is the corner of four pixels; column 50 begins at x = 0, where the square does.
  EXPECT_FALSE(around(scene, {"renderer=ray-tracer"}, {49, 52})) << "the edge is in the margin";
  EXPECT_FALSE(around(scene, {"renderer=rasterizer"}, {50, 52}));
  EXPECT_TRUE(around(scene, {"renderer=ray-tracer"}, {48, 52}));
}

TEST(PixelSurroundings, ShadowsAreBordersToo) {
  const Scene scene = load_scene("cgfs/shadows");
  Settings settings = settings_for(scene);
  RenderRequest request;
  request.channels = Channel::ids | Channel::shadow;
  Prepared prepared;
  Progress progress;
  const View view{scene.camera, side, side};
  const Frame frame = render(scene, view, settings, request, prepared, progress);
  int borders = 0, blocked = 0;
  for (int y = 60; y < side; y += 9)
    for (int x = 3; x < side; x += 13) {
      const Microscope scope(scene, view, settings, {x, y}, prepared, progress);
      const auto& found = scope.surroundings();
      if (!found) continue;
      for (const SeenPixel& one : found->around) {
        std::uint32_t mask = 0;
        for (const int light : one.blocked) mask |= 1U << light;
        ASSERT_EQ(mask, frame.shadow.at(one.pixel.x, one.pixel.y));
        blocked += one.blocked.empty() ? 0 : 1;
      }
      if (found->edge && found->edge->here == found->edge->beyond) ++borders;
    }
  EXPECT_GT(borders, 1);
  EXPECT_GT(blocked, 3);
}

TEST(PixelSurroundings, FarFromAllEdgesItSaysHowFarItLooked) {
  const Scene scene = parse_scene("light { type = ambient intensity = 1 }\n"
                                  "plane { point = (0, 0, 5) normal = (0, 0, -1) color = white }\n",
                                  "plane.scene", ".");
  const auto found = around(scene, {"renderer=ray-tracer"}, {50, 50});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->edge);
  EXPECT_EQ(found->searched, 64);
  EXPECT_FALSE(around(scene, {"renderer=textbook"}, {50, 50})) << "a listing does not say what it shows";
}

}  // namespace
}  // namespace pixel_surroundings_test
