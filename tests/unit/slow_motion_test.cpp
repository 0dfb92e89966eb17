// Slow motion: a state equals what an ordinary render gives of less: of a scene without the later triangles, or of the
// whole picture where it is stored already. Every comparison is bit for bit.
#include "render/slow_motion.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "base/check.h"
#include "document/permalink.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"
#include "support/trials.h"

namespace ps::slow_motion_test {
namespace {

struct Set {
  Scene scene;
  Settings settings;
  View view;
};

Frame whole(const Set& set, Channel channels = Channel::ids | Channel::depth | Channel::overdraw) {
  return render(set.scene, set.view, set.settings, request_for(channels));
}

SlowFrame after(const Set& set, SlowUnit unit, std::uint64_t at,
                Channel channels = Channel::ids | Channel::depth | Channel::overdraw) {
  Prepared prepared;
  Progress progress;
  return render_slowly(set.scene, set.view, set.settings, {unit, at}, request_for(channels), prepared, progress);
}

bool same_bits(const Frame& a, const Frame& b) {
  return a.colour == b.colour && a.colour_double == b.colour_double && a.depth == b.depth && a.ids == b.ids &&
         a.overdraw == b.overdraw;
}

/// The corners of triangles that lie through each other, some of them cut by the edges of the view and by its near
/// plane.
std::vector<std::array<Vec3d, 3>> soup() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> across(-1.5, 1.5), away(0.6, 5);
  std::vector<std::array<Vec3d, 3>> triangles(30);
  for (auto& triangle : triangles)
    for (Vec3d& corner : triangle) {
      const double z = away(random);
      corner = {across(random) * z / 3, across(random) * z / 3, z};
    }
  return triangles;
}

/// A scene of one model with the triangles that are named, in the order in which the soup has them.
Set soup_set(const std::vector<bool>& kept, std::initializer_list<const char*> assignments) {
  std::string vertices, faces;
  const auto triangles = soup();
  int count = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      vertices +=
          fmt::format("{} = ({}, {}, {})\n", 3 * i + k, triangles[i][k].x, triangles[i][k].y, triangles[i][k].z);
    if (kept[i])
      faces +=
          fmt::format("{} = {}, {}, {}, ({}, {}, 90)\n", count++, 3 * i, 3 * i + 1, 3 * i + 2, 40 + 7 * i, 250 - 6 * i);
  }
  const std::string text =
      fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\nlight {{ type = ambient intensity = 0.4 }}\n"
                  "light {{ type = point intensity = 0.6 position = (2, 1, 0) }}\n"
                  "model {{ name = soup vertices {{ {} }} triangles {{ {} }} }}\ninstance {{ model = soup }}\n",
                  vertices, faces);
  Set set;
  set.scene = parse_scene(text, "soup.scene", ".");
  set.settings.renderer = Renderer::rasterizer;
  set.settings.backface_culling = false;
  for (const char* assignment : assignments) parse_assignment(assignment, set.settings);
  set.view = {set.scene.camera, 150, 110};
  return set;
}

std::vector<bool> all_kept() { return std::vector<bool>(soup().size(), true); }

/// Ends of the range and some numbers inside it.
std::vector<std::uint64_t> numbers_up_to(std::uint64_t total, std::size_t count = test::trial_divisor > 1 ? 5 : 8) {
  std::mt19937_64 random(total);
  std::vector<std::uint64_t> numbers{0, 1, total};
  while (numbers.size() < count) numbers.push_back(std::uniform_int_distribution<std::uint64_t>(0, total)(random));
  return numbers;
}

std::uint64_t total_of(const Set& set, SlowUnit unit) { return after(set, unit, 0).state.total; }

/// The triangles of the soup in the order in which they are drawn, found out here.
std::vector<int> drawing_order(const Set& set) {
  const auto triangles = soup();
  std::vector<int> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  const auto depth = [&](int i) {
    const auto& t = triangles[static_cast<std::size_t>(i)];
    return (t[0].z + t[1].z + t[2].z) / 3;
  };
  if (set.settings.visibility == Visibility::painter)
    std::sort(order.begin(), order.end(), [&](int a, int b) { return depth(a) > depth(b); });
  return order;
}

/// A picture after some triangles is that of a scene that never had the later ones. Triangles outside the view are not
/// counted, so the state names the last one.
void expect_scene_without_the_later(std::initializer_list<const char*> assignments) {
  const Set set = soup_set(all_kept(), assignments);
  const std::vector<int> order = drawing_order(set);
  const std::uint64_t total = total_of(set, SlowUnit::triangles);
  ASSERT_GT(total, 20u);
  EXPECT_TRUE(same_bits(after(set, SlowUnit::triangles, total).frame, whole(set)));
  EXPECT_TRUE(same_bits(after(set, SlowUnit::triangles, total + 5).frame, whole(set)));
  int last_place = -1;
  for (std::uint64_t at = 1; at <= total; ++at) {
    const SlowFrame slow = after(set, SlowUnit::triangles, at);
    const auto place = std::find(order.begin(), order.end(), slow.state.id.triangle) - order.begin();
    ASSERT_GT(place, last_place) << "each is one that comes later in the order";
    last_place = static_cast<int>(place);
    std::vector<bool> kept(order.size(), false);
    for (int i = 0; i <= last_place; ++i) kept[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])] = true;
    const Frame reference = whole(soup_set(kept, assignments), Channel::depth | Channel::overdraw);
    const Frame shown = after(set, SlowUnit::triangles, at, Channel::depth | Channel::overdraw).frame;
    ASSERT_TRUE(same_bits(shown, reference)) << at << " of " << total;
    if (at > 1) {
      ASSERT_FALSE(
          same_bits(after(set, SlowUnit::triangles, at - 1, Channel::depth | Channel::overdraw).frame, reference))
          << "one less is another state: each of these triangles covers a pixel";
    }
  }
}

TEST(SlowMotion, DepthBufferAfterTriangles) { expect_scene_without_the_later({"visibility=depth-buffer"}); }
TEST(SlowMotion, PainterAfterTriangles) { expect_scene_without_the_later({"visibility=painter"}); }
TEST(SlowMotion, DrawOrderInDoubleAfterTriangles) {
  expect_scene_without_the_later({"visibility=draw-order", "precision=double"});
}
TEST(SlowMotion, MultisampledAfterTriangles) { expect_scene_without_the_later({"multisampling=4"}); }
TEST(SlowMotion, TiledCoverageAfterTriangles) { expect_scene_without_the_later({"coverage=tiled", "shading=flat"}); }

/// The first walk fills the depth buffer alone; in the second each pixel is written once, by the triangle that wins.
TEST(SlowMotion, EarlyDepthWritesEachPixelOnce) {
  for (const char* several : {"early-depth=on", "light-passes=many"}) {
    const Set set = soup_set(all_kept(), {several});
    const Frame finished = whole(set);
    const Set one_walk = soup_set(all_kept(), {});
    const std::uint64_t each = total_of(one_walk, SlowUnit::triangles), total = total_of(set, SlowUnit::triangles);
    ASSERT_EQ(total % each, 0u);
    ASSERT_GE(total, 2 * each);
    for (std::uint64_t at = 0; at <= 2 * each; at += 3) {
      const SlowFrame slow = after(set, SlowUnit::triangles, at);
      const Frame depth_only = after(one_walk, SlowUnit::triangles, std::min(at, each)).frame;
      EXPECT_EQ(slow.frame.overdraw, depth_only.overdraw) << "the first walk covers the same pixels";
      for (int y = 0; y < 110; ++y)
        for (int x = 0; x < 150; ++x) {
          const int winner = finished.ids.at(x, y).triangle;
          const bool written = at > each && winner >= 0 && winner <= slow.state.id.triangle;
          ASSERT_EQ(slow.frame.ids.at(x, y), written ? finished.ids.at(x, y) : PixelId{}) << x << " " << y << " " << at;
        }
    }
    EXPECT_TRUE(same_bits(after(set, SlowUnit::triangles, total).frame, finished));
  }
}

TEST(SlowMotion, DeferredShadingShowsNothingUntilItsLastStep) {
  const Set set = soup_set(all_kept(), {"deferred-shading=on"});
  const std::uint64_t total = total_of(set, SlowUnit::triangles);
  const Frame before = after(set, SlowUnit::triangles, total - 1).frame;
  EXPECT_EQ(before.colour, after(set, SlowUnit::triangles, 0).frame.colour);
  EXPECT_EQ(before.overdraw, whole(set).overdraw);
  EXPECT_TRUE(same_bits(after(set, SlowUnit::triangles, total).frame, whole(set)));
}

/// After fragment n as many have been counted, pixels are those of the states after the triangles around it, and the
/// next one is one more.
TEST(SlowMotion, FragmentsLieBetweenTriangles) {
  for (const char* way :
       {"visibility=depth-buffer", "visibility=painter", "coverage=hierarchical", "coverage=scanline", "early-depth=on",
        "precision=double", "coverage=micropolygon", "edge-arithmetic=float-stepped"}) {
    const Set set = soup_set(all_kept(), {way});
    const std::uint64_t total = total_of(set, SlowUnit::fragments);
    EXPECT_TRUE(same_bits(after(set, SlowUnit::fragments, total).frame, whole(set))) << way;
    const auto sum = [](const Frame& frame) {
      return std::accumulate(frame.overdraw.pixels().begin(), frame.overdraw.pixels().end(), std::uint64_t{0});
    };
    const bool one_walk = std::string_view(way) != "early-depth=on";
    if (!one_walk) continue;
    std::uint64_t fragments = 0;
    const std::uint64_t triangles = total_of(set, SlowUnit::triangles);
    for (std::uint64_t n = 1; n <= triangles; n += 7) {
      const SlowFrame state = after(set, SlowUnit::triangles, n);
      fragments = sum(state.frame);
      const SlowFrame same = after(set, SlowUnit::fragments, fragments);
      EXPECT_TRUE(same_bits(same.frame, state.frame)) << way << " " << n;
      EXPECT_EQ(same.state.id, state.state.id) << way;
      const SlowFrame less = after(set, SlowUnit::fragments, fragments - 1);
      EXPECT_EQ(sum(less.frame), fragments - 1) << way;
      const Vec2i pixel = same.state.pixel.value();
      EXPECT_EQ(less.frame.overdraw.at(pixel.x, pixel.y) + 1, same.frame.overdraw.at(pixel.x, pixel.y)) << way;
    }
  }
}

/// Pixels that are stored once: those that are done equal the whole picture, as many as were asked for, and all others
/// the background.
void expect_part_of_whole(const Set& set, SlowUnit unit) {
  const Frame finished = whole(set);
  const Frame nothing = after(set, unit, 0).frame;
  const std::uint64_t total = total_of(set, unit);
  for (const float channel : {nothing.colour.at(3, 4).x, nothing.colour.at(3, 4).y}) EXPECT_GE(channel, 0);
  EXPECT_TRUE(same_bits(after(set, unit, total).frame, finished));
  for (const std::uint64_t at : numbers_up_to(total)) {
    const SlowFrame slow = after(set, unit, at);
    std::uint64_t differs = 0, of_whole = 0;
    for (int y = 0; y < set.view.height; ++y)
      for (int x = 0; x < set.view.width; ++x) {
        const bool done = slow.frame.overdraw.at(x, y) == finished.overdraw.at(x, y) &&
                          slow.frame.colour.at(x, y) == finished.colour.at(x, y);
        const bool blank = slow.frame.colour.at(x, y) == Vec3f(set.scene.background);
        ASSERT_TRUE(done || blank);
        differs += done ? 0 : 1;
        of_whole += done && !blank ? 1 : 0;
      }
    if (unit == SlowUnit::pixels) {
      EXPECT_LE(of_whole, at);
      EXPECT_LE(differs, total - at);
    }
    EXPECT_EQ(slow.state.done.at, at);
  }
}

Set traced(std::initializer_list<const char*> assignments) {
  Set set;
  set.scene = load_scene("cgfs/reflections");
  set.scene.background = {0.2, 0.3, 0.4};
  for (const char* assignment : assignments) parse_assignment(assignment, set.settings);
  set.view = {set.scene.camera, 75, 70};
  return set;
}

TEST(SlowMotion, RaysArePartsOfTheWhole) {
  for (const auto unit : {SlowUnit::pixels, SlowUnit::rows, SlowUnit::tiles}) {
    expect_part_of_whole(traced({}), unit);
    expect_part_of_whole(traced({"subsampling=4"}), unit);
    expect_part_of_whole(traced({"samples-per-pixel=4", "precision=double"}), unit);
    expect_part_of_whole(traced({"shadow-cache=on", "simd=off"}), unit);
  }
  expect_part_of_whole(soup_set(all_kept(), {}), SlowUnit::tiles);
}

/// Pixel n is the one that comes after pixel n - 1 in its tile of 32 x 32, and exactly it changes.
TEST(SlowMotion, OnePixelMoreIsThePixelThatIsNamed) {
  const Set set = traced({"renderer=ray-tracer"});
  const Frame finished = whole(set);
  for (const std::uint64_t at : {1ull, 32ull, 33ull, 1024ull, 1025ull, 2048ull, 2300ull, 75ull * 70}) {
    const SlowFrame more = after(set, SlowUnit::pixels, at), less = after(set, SlowUnit::pixels, at - 1);
    const Vec2i named = more.state.pixel.value();
    for (int y = 0; y < 70; ++y)
      for (int x = 0; x < 75; ++x)
        if (Vec2i(x, y) == named)
          ASSERT_EQ(more.frame.colour.at(x, y), finished.colour.at(x, y));
        else
          ASSERT_EQ(more.frame.colour.at(x, y), less.frame.colour.at(x, y));
    EXPECT_EQ(less.frame.colour.at(named.x, named.y), Vec3f(set.scene.background));
  }
  EXPECT_EQ(after(set, SlowUnit::pixels, 33).state.pixel, Vec2i(0, 1)) << "the second row of the first tile";
  EXPECT_EQ(after(set, SlowUnit::pixels, 1025).state.pixel, Vec2i(32, 0)) << "the first pixel of the second tile";
}

/// The mean of the first samples, added up here from pictures with one ray through each sample's place.
TEST(SlowMotion, SamplesAreTheMeanOfThoseSoFar) {
  for (const char* simd : {"simd=auto", "simd=off"}) {
    const Set set = traced({"samples-per-pixel=9", "sample-pattern=halton", simd});
    EXPECT_EQ(total_of(set, SlowUnit::samples), 9u);
    EXPECT_TRUE(same_bits(after(set, SlowUnit::samples, 9).frame, whole(set)));
    const Frame two = after(set, SlowUnit::samples, 2).frame, five = after(set, SlowUnit::samples, 5).frame;
    for (int y = 5; y < 70; y += 16)
      for (int x = 3; x < 75; x += 11) {
        const PixelStory story = inspect(set.scene, set.view, set.settings, {x, y});
        Vec3f sum(0);
        int taken = 0;
        for (const auto* sample : events_of<SampleEvent>(story.events)) {
          sum += Vec3f(sample->colour);
          ++taken;
          if (taken == 2 || taken == 5) {
            ASSERT_EQ((taken == 2 ? two : five).colour.at(x, y), sum / static_cast<float>(taken));
          }
        }
        ASSERT_EQ(taken, 9);
      }
  }
}

TEST(SlowMotion, AdaptiveSamplingGoesOverThePictureTwice) {
  const Set set = traced({"samples-per-pixel=9", "adaptive-sampling=on"}), plain = traced({});
  const std::uint64_t pixels = 75 * 70, total = total_of(set, SlowUnit::pixels);
  ASSERT_GT(total, pixels);
  EXPECT_TRUE(same_bits(after(set, SlowUnit::pixels, pixels).frame, whole(plain))) << "first rays alone";
  EXPECT_TRUE(same_bits(after(set, SlowUnit::pixels, total).frame, whole(set)));
  EXPECT_FALSE(same_bits(after(set, SlowUnit::pixels, total - 1).frame, whole(set)));
}

/// A listing's state: the last of its writes up to n counts at each pixel.
TEST(SlowMotion, ListingsWriteInTheirOwnOrder) {
  constexpr int side = 150;  // what lies on the canvas is not too far outside
  for (const char* name : {"cgfs/spheres", "cgfs/shaded-triangle", "cgfs/cubes", "cgfs/lines"}) {
    Set set;
    set.scene = load_scene(name);
    set.settings = settings_for(set.scene);
    set.settings.renderer = Renderer::textbook;
    set.view = {set.scene.camera, side, side};
    const Frame finished = whole(set, Channel::none);
    const std::uint64_t total = after(set, SlowUnit::writes, 0, Channel::none).state.total;
    ASSERT_GT(total, 0u) << name;
    EXPECT_TRUE(same_bits(after(set, SlowUnit::writes, total, Channel::none).frame, finished)) << name;
    for (const std::uint64_t at : numbers_up_to(total)) {
      if (at == 0) continue;
      const SlowFrame more = after(set, SlowUnit::writes, at, Channel::none);
      const SlowFrame less = after(set, SlowUnit::writes, at - 1, Channel::none);
      const Vec2i named = more.state.pixel.value();
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          if (Vec2i(x, y) != named) {
            ASSERT_EQ(more.frame.colour.at(x, y), less.frame.colour.at(x, y)) << name;
          }
    }
  }
}

/// The book's loop goes over x outside and over y inside (CGFS ch. 2), from the lowest row up.
TEST(SlowMotion, TheBooksLoopGoesColumnByColumn) {
  Set set = traced({"renderer=textbook"});
  const auto place = [&](std::uint64_t at) { return after(set, SlowUnit::writes, at, Channel::none).state.pixel; };
  const Vec2i first = place(1).value();
  EXPECT_EQ(first.x, 0);
  for (const std::uint64_t at : {2ull, 40ull, 70ull}) EXPECT_EQ(place(at)->x, 0);
  EXPECT_EQ(place(71)->x, 1);
}

TEST(SlowMotion, ShapesOnTheCanvasComeOneByOne) {
  for (const char* name : {"lab/polygon-rows", "lab/polygons", "cgfs/lines", "cgfs/shaded-triangle"}) {
    Set set;
    set.scene = load_scene(name);
    set.settings = settings_for(set.scene);
    set.settings.renderer = Renderer::rasterizer;
    set.view = {set.scene.camera, set.scene.canvas_width, set.scene.canvas_height};
    const std::uint64_t total = total_of(set, SlowUnit::triangles);
    EXPECT_EQ(total, set.scene.canvas_items->size());
    for (std::uint64_t at = 0; at <= total; ++at) {
      Set less = set;
      auto items = *set.scene.canvas_items;
      items.resize(static_cast<std::size_t>(at));
      less.scene.canvas_items = Part<std::vector<CanvasItem>>(items);
      EXPECT_EQ(after(set, SlowUnit::triangles, at).frame.colour, whole(less).colour);
    }
  }
}

/// The means of samples do not cover the shapes that come after them.
TEST(SlowMotion, TheLastFragmentLeavesShapesOverMultisampledPixels) {
  for (const char* name : {"lab/polygons", "cgfs/shaded-triangle"}) {
    Set set;
    set.scene = load_scene(name);
    set.settings = settings_for(set.scene);
    set.settings.renderer = Renderer::rasterizer;
    set.settings.multisampling = 4;
    set.view = {set.scene.camera, 120, 120};
    EXPECT_EQ(after(set, SlowUnit::fragments, total_of(set, SlowUnit::fragments)).frame.colour, whole(set).colour)
        << name;
  }
}

TEST(SlowMotion, ThreadsChangeNothing) {
  for (const auto unit : {SlowUnit::triangles, SlowUnit::fragments, SlowUnit::tiles}) {
    Set set = soup_set(all_kept(), {});
    const std::uint64_t at = total_of(set, unit) / 3;
    const Frame one = after(set, unit, at).frame;
    set.settings.threads = 7;
    EXPECT_TRUE(same_bits(after(set, unit, at).frame, one));
  }
}

TEST(SlowMotion, TextIsReadBack) {
  for (const SlowUnitRow& row : slow_units()) {
    const SlowMotion motion{row.unit, 17};
    EXPECT_EQ(parse_slow_motion(slow_motion_text(motion)), motion);
  }
  for (const char* bad : {"", "triangles", "triangles:", "triangles:-1", "triangles:1.5", "cubes:3", "triangles:3 ",
                          "triangles:99999999999999999999"})
    EXPECT_THROW(parse_slow_motion(bad), InputError) << bad;
}

TEST(SlowMotion, IsPartOfAPermalink) {
  Document document;
  document.a.slow_motion = SlowMotion{SlowUnit::triangles, 17};
  document.b.slow_motion = SlowMotion{SlowUnit::rows, 0};
  EXPECT_EQ(permalink(document), "slow-motion-a=triangles:17&slow-motion-b=rows:0");
  const Document read = parse_permalink(permalink(document));
  EXPECT_EQ(read.a, document.a);
  EXPECT_EQ(read.b, document.b);
}

TEST(SlowMotion, WhatARendererLacksIsRefusedWithTheReason) {
  const Set rays = traced({});
  for (const auto unit : {SlowUnit::triangles, SlowUnit::fragments, SlowUnit::samples, SlowUnit::writes}) {
    EXPECT_TRUE(slow_motion_lacks(unit, rays.settings, scene_traits(rays.scene)));
    EXPECT_THROW(after(rays, unit, 3), InputError);
  }
  EXPECT_EQ(first_slow_unit(rays.settings, scene_traits(rays.scene)), SlowUnit::pixels);
}

TEST(SlowMotion, WordsNameTheLastOne) {
  const Set set = soup_set(all_kept(), {});
  const Vec2i size{150, 110};
  const SlowState state = after(set, SlowUnit::triangles, 4).state;
  EXPECT_EQ(slow_motion_words(state, set.scene, size),
            fmt::format("triangle 4 of {}: triangle {} of soup", state.total, state.id.triangle));
  const Set rays = traced({});
  EXPECT_EQ(slow_motion_words(after(rays, SlowUnit::pixels, 1025).state, rays.scene, {75, 70}),
            "pixel 1,025 of 5,250: (32, 0), row 1 of 70");
  EXPECT_EQ(slow_motion_words(after(rays, SlowUnit::rows, 40).state, rays.scene, {75, 70}), "row 40 of 70");
}

}  // namespace
}  // namespace ps::slow_motion_test
