// What the microscope has to say on a pixel without edges.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "inspect/microscope/microscope.h"
#include "obj_corpus.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::pixel_surroundings_test {
namespace {

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
  Settings settings = settings_with(settings_for(scene), assignments);
  Prepared prepared;
  Progress progress;
  const Microscope scope(scene, {scene.camera, side, side}, settings, pixel, prepared, progress);
  return scope.surroundings();
}

/// The nearest pixel with another object beside it, looked for in the whole picture.
double nearest_by_hand(const Scene& scene, Vec2i from) {
  Settings settings = settings_for(scene, Renderer::ray_tracer);
  const Frame frame = render(scene, {scene.camera, side, side}, settings, request_for(Channel::ids));
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

/// The whole picture with what is looked for around pixels.
Frame ids_and_shadows(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared) {
  Progress progress;
  return render(scene, view, settings, request_for(Channel::ids | Channel::shadow), prepared, progress);
}

/// As the picture's channel has it.
std::uint32_t shadow_mask(const SeenPixel& seen) {
  std::uint32_t mask = 0;
  for (const int light : seen.blocked) mask |= 1U << light;
  return mask;
}

TEST(PixelSurroundings, ShadowsAreBordersToo) {
  const Scene scene = load_scene("cgfs/shadows");
  const Settings settings = settings_for(scene);
  Prepared prepared;
  Progress progress;
  const View view{scene.camera, side, side};
  const Frame frame = ids_and_shadows(scene, view, settings, prepared);
  int borders = 0, blocked = 0;
  for (int y = 60; y < side; y += 9)
    for (int x = 3; x < side; x += 13) {
      const Microscope scope(scene, view, settings, {x, y}, prepared, progress);
      const auto& found = scope.surroundings();
      if (!found) continue;
      for (const SeenPixel& one : found->around) {
        ASSERT_EQ(shadow_mask(one), frame.shadow.at(one.pixel.x, one.pixel.y));
        blocked += one.blocked.empty() ? 0 : 1;
      }
      if (found->edge && found->edge->here == found->edge->beyond) ++borders;
    }
  EXPECT_GT(borders, 1);
  EXPECT_GT(blocked, 3);
}

/// Where the nearest pixel lies that shows something else than a neighbour, in the whole picture with all that colours
/// it.
struct Expected {
  std::optional<Vec2i> edge;
  std::uint32_t shadow = 0;  ///< at the pixel itself
};
Expected expected_of(const Frame& frame, Vec2i from) {
  Expected expected;
  expected.shadow = frame.shadow.at(from.x, from.y);
  const auto differ = [&](Vec2i a, Vec2i b) {
    return frame.ids.at(a.x, a.y) != frame.ids.at(b.x, b.y) || frame.shadow.at(a.x, a.y) != frame.shadow.at(b.x, b.y);
  };
  int least = 0;
  for (int y = std::max(from.y - 64, 0); y <= std::min(from.y + 64, side - 1); ++y)
    for (int x = std::max(from.x - 64, 0); x <= std::min(from.x + 64, side - 1); ++x) {
      const int distance = (x - from.x) * (x - from.x) + (y - from.y) * (y - from.y);
      if (expected.edge && distance >= least) continue;
      for (const Vec2i step : {Vec2i{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const Vec2i beside = Vec2i{x, y} + step;
        if (std::max(std::abs(beside.x - from.x), std::abs(beside.y - from.y)) > 64) continue;
        if (!frame.ids.contains(beside.x, beside.y) || !differ({x, y}, beside)) continue;
        expected.edge = Vec2i{x, y};
        least = distance;
        break;
      }
    }
  return expected;
}

struct Compared {
  int pixels = 0, edges = 0, shadowed = 0;
};

/// Looks around some pixels; what is found must be as the whole picture has it.
Compared compare_with_picture(const Scene& scene, const std::vector<const char*>& assignments) {
  Settings settings = settings_with(settings_for(scene), assignments);
  Prepared prepared;
  Progress progress;
  const View view{scene.camera, side, side};
  const Frame frame = ids_and_shadows(scene, view, settings, prepared);
  Compared compared;
  for (int y = 5; y < side; y += 33)
    for (int x = 3; x < side; x += 25) {
      const auto seen = look_around(scene, view, settings, {x, y}, prepared, progress);
      if (!seen) continue;
      ++compared.pixels;
      const Expected expected = expected_of(frame, {x, y});
      const std::string where =
          scene.name + " " + assignments.front() + " " + std::to_string(x) + " " + std::to_string(y);
      EXPECT_EQ(seen->edge.has_value(), expected.edge.has_value()) << where;
      if (!seen->edge || !expected.edge) continue;
      ++compared.edges;
      compared.shadowed += expected.shadow != 0 ? 1 : 0;
      EXPECT_EQ(seen->edge->pixel, *expected.edge) << where;
      std::uint32_t mask = 0;
      for (const SeenPixel& one : seen->around)
        if (one.pixel == Vec2i{x, y}) mask = shadow_mask(one);
      EXPECT_EQ(mask, expected.shadow) << where;
    }
  return compared;
}

// What only colours a pixel is left out while looking: mirrors, textures, and light where there are no shadows. What
// decides which things are seen and which lights reach them is not.
TEST(PixelSurroundings, AreThoseOfThePictureWithAllItsColours) {
  const std::vector<std::pair<const char*, std::vector<const char*>>> pictures{
      {"cgfs/reflections", {"renderer=ray-tracer"}},
      {"cgfs/reflections", {"renderer=ray-tracer", "shadow-rays=useful"}},
      {"cgfs/reflections", {"renderer=ray-tracer", "shadows=none"}},
      {"cgfs/shading", {"renderer=ray-tracer", "self-hit=normal-bump", "shadow-epsilon=0.05"}},
      {"cgfs/relief", {"renderer=ray-tracer", "parallax-mapping=steep"}},
      {"cgfs/magnifying-glass", {"renderer=ray-tracer"}},
      {"cgfs/crates", {"renderer=rasterizer"}},
      {"cgfs/relief", {"renderer=rasterizer", "parallax-mapping=steep"}},
      {"cgfs/shadows", {"renderer=rasterizer", "shadows=map", "shadow-map-size=64"}},
      {"cgfs/shadows", {"renderer=rasterizer", "shadows=stencil-depth-fail"}},
      {"lab/mirror-room", {"renderer=rasterizer", "environment-size=8"}}};
  int edges = 0, shadowed = 0;
  for (const auto& [name, assignments] : pictures) {
    const Compared some = compare_with_picture(load_scene(name), assignments);
    EXPECT_EQ(some.pixels, 12) << name;
    edges += some.edges;
    shadowed += some.shadowed;
  }
  EXPECT_GT(edges, 90);
  EXPECT_GT(shadowed, 10);
}

// Fragments that an opacity map cuts out show what is behind them; rays meet the surface all the same.
TEST(PixelSurroundings, HolesOfAnOpacityMapAreSeen) {
  const test::ModelFolder folder;
  folder.write("cut.pgm", "P2 2 1 255 255 0\n");
  const Scene scene = parse_scene(
      "background = linear (0, 0, 1)\ntexture { name = t file = cut.pgm }\n"
      "material { name = m color = red opacity_map = t }\nlight { type = ambient intensity = 1 }\n"
      "model { name = wall material = m vertices = [(-2, -2, 2), (-2, 2, 2), (2, 2, 2), (2, -2, 2)]\n"
      "  uvs = [(0, 1), (0, 0), (1, 0), (1, 1)]\n"
      "  triangles { 0 = { vertices = [0, 1, 2] uvs = [0, 1, 2] } 1 = { vertices = [0, 2, 3] uvs = [0, 2, 3] } } }\n"
      "instance { model = wall }\n",
      "wall.scene", folder.path().string());
  for (const char* renderer : {"renderer=rasterizer", "renderer=ray-tracer"})
    EXPECT_GT(compare_with_picture(scene, {renderer}).edges, 8);
  const auto hole = around(scene, {"renderer=rasterizer"}, {75, 55});
  ASSERT_TRUE(hole && hole->edge);
  EXPECT_EQ(hole->around.front().seen, "the background");
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
}  // namespace ps::pixel_surroundings_test
