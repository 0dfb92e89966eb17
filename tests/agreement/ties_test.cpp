// At equal depth or distance the lowest index wins: the rule itself, on surfaces that lie exactly in each other. Who
// owns a pixel follows here from the order in the file and from which outlines hold the pixel, not from another
// renderer.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "options/option.h"
#include "scene/scene_file.h"
#include "support/emulated.h"
#include "support/render_once.h"
#include "support/settings_with.h"
#include "support/simd_targets.h"

namespace ps::ties_test {
namespace {

/// Several lists of assignments, each of which is tried.
using Ways = std::vector<std::vector<std::string>>;

/// Each of `first` joined with each of `second`.
Ways combined(const Ways& first, const Ways& second) {
  Ways result;
  for (const auto& a : first)
    for (const auto& b : second) {
      result.push_back(a);
      result.back().insert(result.back().end(), b.begin(), b.end());
    }
  return result;
}

Ways joined(Ways first, const Ways& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Ways choices_of(std::string_view key) {
  Ways ways;
  for (const Choice& choice : find_option(key)->choices) ways.push_back({fmt::format("{}={}", key, choice.key)});
  return ways;
}

const Ways fast_and_clear{{"simd=auto"}, {"simd=off"}};

Ways ray_ways() {
  Ways ways = combined(combined(choices_of("accelerator"), fast_and_clear),
                       {{}, {"precision=double"}, {"cache-constants=off"}});
  ways = joined(ways, combined(choices_of("triangle-test"), combined(choices_of("accelerator"), fast_and_clear)));
  for (const char* key : {"sphere-test", "simd", "slab-test"}) ways = joined(ways, choices_of(key));
  ways = joined(ways, {{"threads=1"}, {"threads=7"}, {"subsampling=4"}, {"lighting=on"}});
  ways = joined(ways, {{"accelerator=octree", "octree-leaf=1"}, {"accelerator=octree", "octree-depth=0"}});
  return combined({{"renderer=ray-tracer", "near=0.001"}}, ways);
}

/// All ways to keep depths, and to decide first what is visible.
Ways depth_ways() {
  const Ways depths =
      combined(choices_of("depth-value"), {{"depth-format=plain"},
                                           {"depth-format=unit-float"},
                                           {"depth-format=unit-float", "depth-reversed=on"},
                                           {"depth-format=unorm", "depth-bits=24"},
                                           {"depth-format=unorm", "depth-bits=8", "depth-reversed=on"}});
  const Ways orders{{}, {"early-depth=on"}, {"deferred-shading=on"}, {"light-passes=many", "lighting=on"}};
  return combined({{"renderer=rasterizer"}}, combined(fast_and_clear, combined(depths, orders)));
}

Ways cover_ways() {
  Ways ways;
  for (const char* key : {"coverage", "edge-arithmetic", "fill-rule", "clipping", "simd"})
    ways = joined(ways, choices_of(key));
  ways = joined(ways, combined({{"lighting=on"}}, choices_of("shading")));
  for (const char* way : {"multisampling=2", "multisampling=4", "multisampling=8", "subpixel-bits=4", "threads=1",
                          "threads=7", "interpolation=affine", "camera-relative=off"})
    ways.push_back({way});
  return combined({{"renderer=rasterizer"}}, combined({{}, {"precision=double"}}, ways));
}

Scene scene_of(const std::vector<std::string>& objects) {
  return parse_scene(fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n{}"
                                 "light {{ type = ambient  intensity = 0.5 }}\n"
                                 "light {{ type = directional  intensity = 0.5  direction = (0, 0, -1) }}\n",
                                 fmt::join(objects, "\n")),
                     "ties.scene", ".");
}

Frame draw(const Scene& scene, int size, const std::vector<std::string>& way) {
  Settings settings = settings_with(settings_with({}, {"backface-culling=off", "lighting=off", "far=16"}), way);
  return render(scene, {scene.camera, size, size}, settings, request_for(Channel::ids | Channel::depth));
}

/// Calls body(objects) with the objects in every order.
template <class Object, class Body>
void in_every_order(const std::vector<Object>& objects, Body&& body) {
  std::vector<std::size_t> order(objects.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  do {
    std::vector<Object> ordered;
    std::string trace = "order";
    for (const std::size_t i : order) {
      ordered.push_back(objects[i]);
      trace += fmt::format(" {}", i);
    }
    SCOPED_TRACE(trace);
    body(ordered);
  } while (std::next_permutation(order.begin(), order.end()));
}

// Four triangles in the plane z = 4, each of them a half of the picture: each pixel lies in two. A pixel is 1/16 wide
// there, corners lie on corners of pixels, and areas are powers of two, so that every interpolated depth and every t is
// exactly 4.

constexpr int size = 64;

using Triangle = std::array<Vec2d, 3>;  ///< corners in pixels

const std::vector<Triangle> halves{{Vec2d{0, 0}, Vec2d{size, 0}, Vec2d{0, size}},
                                   {Vec2d{size, size}, Vec2d{0, size}, Vec2d{size, 0}},
                                   {Vec2d{size, 0}, Vec2d{size, size}, Vec2d{0, 0}},
                                   {Vec2d{0, size}, Vec2d{0, 0}, Vec2d{size, size}}};

std::string text_of(const Triangle& triangle) {
  std::vector<std::string> corners;
  for (const Vec2d& p : triangle)
    corners.push_back(fmt::format("({}, {}, 4)", (p.x - size / 2.0) / 16, (size / 2.0 - p.y) / 16));
  return fmt::format("triangle {{ vertices = [{}]  color = white }}", fmt::join(corners, ", "));
}

/// Where a place in pixels lies: 1 inside, 0 on an edge, -1 outside.
int place_in(const Triangle& p, const Vec2d& place) {
  const auto side = [](const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    const double value = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return value > 0 ? 1 : value < 0 ? -1 : 0;
  };
  const int turn = side(p[0], p[1], p[2]);
  return std::min({turn * side(p[0], p[1], place), turn * side(p[1], p[2], place), turn * side(p[2], p[0], place)});
}

enum class Wins { lowest, highest };

/// Number of the triangle that owns the place. Nothing on an edge, where the fill rule decides.
std::optional<int> owner(const std::vector<Triangle>& triangles, const Vec2d& place, Wins wins) {
  std::optional<int> result;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const int inside = place_in(triangles[i], place);
    if (inside == 0) return {};
    if (inside > 0 && (!result || wins == Wins::highest)) result = static_cast<int>(i);
  }
  return result;
}

void expect_owners(const Ways& ways, Wins wins = Wins::lowest) {
  in_every_order(halves, [&](const std::vector<Triangle>& triangles) {
    std::vector<std::string> texts;
    for (const Triangle& triangle : triangles) texts.push_back(text_of(triangle));
    const Scene scene = scene_of(texts);
    for (std::size_t tried = 0; tried < ways.size(); tried += test::trial_step()) {
      const auto& way = ways[tried];
      const Frame frame = draw(scene, size, way);
      int compared = 0, wrong = 0, apart = 0;
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
          const auto expected = owner(triangles, {x + 0.5, y + 0.5}, wins);
          if (!expected) continue;
          ++compared;
          wrong += frame.ids.at(x, y).object != *expected;
          apart += frame.depth.at(x, y) != 4;
        }
      EXPECT_EQ(compared, size * size - 2 * size) << "all but two diagonals";
      EXPECT_EQ(wrong, 0) << fmt::format("{}", fmt::join(way, " "));
      EXPECT_EQ(apart, 0) << "not at the depth that makes a tie: " << fmt::format("{}", fmt::join(way, " "));
    }
  });
}

TEST(Ties, LowestIndexWinsWithEveryDepthBuffer) { expect_owners(depth_ways()); }
TEST(Ties, LowestIndexWinsWithEveryWayToCover) { expect_owners(cover_ways()); }
TEST(Ties, LowestIndexWinsForRaysAtTriangles) { expect_owners(ray_ways()); }

/// The painter draws the lowest index last; in plain draw order the highest one covers all others.
TEST(Ties, WithoutADepthBufferTheOrderOfDrawingDecides) {
  expect_owners(combined({{"renderer=rasterizer", "visibility=painter"}}, fast_and_clear));
  expect_owners(combined({{"renderer=rasterizer", "visibility=draw-order"}}, fast_and_clear), Wins::highest);
}

// Three copies of one thing, and a sphere that they hide: all arithmetic of the copies is the same, whatever it rounds.

const std::vector<std::string> copied{
    "sphere { center = (0.1, -0.2, 4)  radius = 1.1  color = white }",
    "box { center = (0.1, 0, 4)  size = (1.5, 1.4, 1.3)  rotation = <30 degrees around the Y axis>  color = white }",
    "cylinder { from = (0, -0.7, 4)  to = (0.1, 0.9, 4.2)  radius = 0.8  color = white }",
    "rectangle { corner = (-0.9, -1, 4)  side_a = (2, 0, 0.3)  side_b = (0, 2, 0)  color = white }",
    "triangle { vertices = [(-1.3, -1.1, 3.9), (0.3, 1.4, 4.2), (1.2, -1.2, 4.1)]  color = white }",
    R"(intersection { sphere { center = (-0.3, 0, 4)  radius = 1 color = white }
                      sphere { center = (0.3, 0, 4)  radius = 1 color = white } })"};
constexpr const char* hidden = "sphere { center = (0.05, 0, 9)  radius = 0.3  color = white }";
constexpr int kinds_of_triangles = 5;  ///< all but CSG, which only rays see

void expect_first_copy(const std::string& copy, const Ways& ways) {
  for (int before = 0; before <= 3; ++before) {  // copies before the hidden sphere
    SCOPED_TRACE(fmt::format("{}, {} before the hidden sphere", copy, before));
    std::vector<std::string> objects(3, copy);
    objects.insert(objects.begin() + before, hidden);
    const Scene scene = scene_of(objects);
    const int first = before == 0 ? 1 : 0;
    for (std::size_t tried = 0; tried < ways.size(); tried += test::trial_step()) {
      const auto& way = ways[tried];
      const Frame frame = draw(scene, 48, way);
      int seen = 0, wrong = 0;
      for (const PixelId& id : frame.ids.pixels()) {
        seen += id.object >= 0;
        wrong += id.object >= 0 && id.object != first;
      }
      EXPECT_GT(seen, 100) << fmt::format("{}", fmt::join(way, " "));
      EXPECT_EQ(wrong, 0) << fmt::format("{}", fmt::join(way, " "));
    }
  }
}

TEST(Ties, TheFirstOfEqualThingsIsDrawn) {
  for (int i = 0; i < kinds_of_triangles; ++i)
    expect_first_copy(copied[static_cast<std::size_t>(i)], joined(depth_ways(), cover_ways()));
}

TEST(Ties, TheFirstOfEqualThingsIsMetByRays) {
  for (const std::string& copy : copied) expect_first_copy(copy, ray_ways());
}

/// Where things of different kinds touch in the plane z = 4, the ray through the middle of the picture meets all of
/// them at t = 4.
TEST(Ties, TheFirstKindIsMetByRays) {
  const std::vector<std::string> touching{
      "sphere { center = (0, 0, 5)  radius = 1  color = white }",
      "box { center = (0, 0, 4.5)  size = (1, 1, 1)  color = white }",
      "rectangle { corner = (-1, -1, 4)  side_a = (2, 0, 0)  side_b = (0, 2, 0)  color = white }",
      "triangle { vertices = [(-1, -1, 4), (-1, 3, 4), (3, -1, 4)]  color = white }"};
  constexpr int odd = 33;
  in_every_order(touching, [&](const std::vector<std::string>& objects) {
    const Scene scene = scene_of(objects);
    const Ways ways = ray_ways();
    for (std::size_t tried = 0; tried < ways.size(); tried += test::trial_step()) {
      const auto& way = ways[tried];
      const Frame frame = draw(scene, odd, way);
      EXPECT_EQ(frame.ids.at(odd / 2, odd / 2).object, 0) << fmt::format("{}", fmt::join(way, " "));
      EXPECT_EQ(frame.depth.at(odd / 2, odd / 2), 4) << fmt::format("{}", fmt::join(way, " "));
    }
  });
}

/// The code path that draws shows in the names of its stages, or, for rays, in the nodes of the wide tree.
TEST(Ties, TheFastPathsAreAmongTheWays) {
  if (test::simd_targets().empty()) GTEST_SKIP() << "this processor has no SIMD target: all ways are the clear path";
  const Scene scene = scene_of({text_of(halves[0]), text_of(halves[1])});
  EXPECT_TRUE(test::took_fast_frame(draw(scene, size, {"renderer=rasterizer"})));
  EXPECT_NE(draw(scene, size, {}).counters, draw(scene, size, {"simd=off"}).counters);
}

}  // namespace
}  // namespace ps::ties_test
