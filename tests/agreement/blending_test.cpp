// Blending in the output merger (CGPP 15.7.1.3): sorted, it shows what rays see through flat sheets; in draw order it
// goes wrong where a near sheet is drawn first, in a way that can be computed by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "frame/fast_kernels.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/fast_path.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::blending_test {
namespace {

constexpr Vec3d white{1, 1, 1}, red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1};

struct Sheets {
  Scene scene;
  View view;
  Settings settings;

  explicit Sheets(const std::string& name = "lab/translucent-sheets", Vec2i size = {600, 400})
      : scene(load_scene(name)), view{scene.camera, size.x, size.y}, settings(settings_for(scene)) {
    settings.renderer = Renderer::rasterizer;
  }
  Settings with(std::initializer_list<const char*> assignments) const { return settings_with(settings, assignments); }
  Image<Vec3f> draw(std::initializer_list<const char*> assignments) const {
    return render(scene, view, with(assignments), request_for(Channel::none)).colour;
  }
  PixelStory story(Vec2i pixel, std::initializer_list<const char*> assignments) const {
    return inspect(scene, view, with(assignments), pixel);
  }
};

Vec3d half_over(const Vec3d& source, const Vec3d& destination) { return 0.5 * source + 0.5 * destination; }

void expect_near(const Vec3d& found, const Vec3d& expected, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "channel " << i;
}

// 100 pixels are one unit: all three sheets lie over each other at (-1.7, 0.2) and (0.1, 0.2).
constexpr Vec2i back_to_front{130, 180}, front_to_back{310, 180};

TEST(Blending, GivesTheSharesOfTheirOrder) {
  const Sheets sheets;
  const Vec3d right = half_over(blue, half_over(green, half_over(red, white)));
  const Vec3d hidden = half_over(blue, white);  // its depth keeps out the two behind, which come later
  const auto at = [&](Vec2i pixel, const char* blending) {
    return Vec3d(sheets.draw({blending}).at(pixel.x, pixel.y));
  };
  expect_near(at(back_to_front, "blending=sorted"), right, 0);
  expect_near(at(front_to_back, "blending=sorted"), right, 0);
  expect_near(at(back_to_front, "blending=draw-order"), right, 0);
  expect_near(at(front_to_back, "blending=draw-order"), hidden, 0);
  expect_near(at(back_to_front, "blending=off"), blue, 0);
  expect_near(at(front_to_back, "blending=off"), blue, 0);
}

// With shares that are not one half source and destination cannot be exchanged unseen. The far sheet lets a quarter
// through, the near one three quarters.
TEST(Blending, SourceAndDestinationHaveTheirOwnShares) {
  const std::string far = "triangle { vertices = [(-9, -9, 5), (0, 18, 5), (9, -9, 5)]  color = red  "
                          "transparency = 0.25 }\n",
                    near = "triangle { vertices = [(-9, -9, 3), (0, 18, 3), (9, -9, 3)]  color = blue  "
                           "transparency = 0.75 }\n";
  const Vec3d right = 0.25 * blue + 0.75 * (0.75 * red + 0.25 * white), hidden = 0.25 * blue + 0.75 * white;
  for (const bool near_first : {false, true})
    for (const int samples : {1, 4})
      for (const Blending blending : {Blending::sorted, Blending::draw_order}) {
        const Scene scene = parse_scene("background = white\n" + (near_first ? near + far : far + near) +
                                            "settings { renderer = rasterizer  lighting = off }\n",
                                        "sheets.scene", ".");
        Settings settings = settings_for(scene);
        settings.blending = blending;
        settings.multisampling = samples;
        const Frame frame = render(scene, {scene.camera, 20, 20}, settings, request_for(Channel::none));
        const bool sorted = blending == Blending::sorted || !near_first;
        SCOPED_TRACE(std::to_string(samples) + (near_first ? ", near first" : ", far first"));
        expect_near(Vec3d(frame.colour.at(10, 10)), sorted ? right : hidden, 1e-6);
      }
}

Vec3d colour_at(const std::string& objects, Vec2i pixel, int samples = 1) {
  const Scene scene = parse_scene("background = white\n" + objects +
                                      "settings { renderer = rasterizer  lighting = off  blending = sorted }\n",
                                  "sheets.scene", ".");
  Settings settings = settings_for(scene);
  settings.multisampling = samples;
  const Frame frame = render(scene, {scene.camera, 20, 20}, settings, request_for(Channel::none));
  return Vec3d(frame.colour.at(pixel.x, pixel.y));
}

// Where two sheets cross, the one that is drawn last lies over the other one on either side: a depth that the first one
// left behind would hide the second where it is behind. Where two lie in the same place, the scene's first is on top.
TEST(Blending, TranslucentSheetsHideNoOther) {
  const std::string falling = "triangle { vertices = [(-9, -30, 2), (-9, 30, 2), (9, 0, 12)]  color = red  "
                              "transparency = 0.5 }\n",
                    rising = "triangle { vertices = [(9, -30, 1), (-9, 0, 11), (9, 30, 1)]  color = blue  "
                             "transparency = 0.5 }\n";
  const Vec3d crossing = half_over(blue, half_over(red, white));
  for (const int samples : {1, 4})
    for (const int column : {2, 17}) {
      SCOPED_TRACE(std::to_string(samples) + " samples, column " + std::to_string(column));
      expect_near(colour_at(falling + rising, {column, 10}, samples), crossing, 1e-6);
      expect_near(colour_at(rising + falling, {column, 10}, samples), crossing, 1e-6);
    }
  const std::string place = "triangle { vertices = [(-9, -9, 5), (0, 18, 5), (9, -9, 5)]  transparency = 0.5  color = ";
  expect_near(colour_at(place + "red }\n" + place + "blue }\n", {10, 10}), half_over(red, half_over(blue, white)),
              1e-6);
}

// Opaque surfaces come first, also one behind the near end of a sheet whose middle is farther away.
TEST(Blending, OpaqueSurfacesComeFirst) {
  const std::string sheet = "triangle { vertices = [(-9, -90, 2), (-9, 90, 2), (99, 0, 60)]  color = blue  "
                            "transparency = 0.5 }\n",
                    opaque = "triangle { vertices = [(-90, -90, 9), (0, 180, 9), (90, -90, 9)]  color = red }\n";
  for (const std::string& objects : {sheet + opaque, opaque + sheet})
    expect_near(colour_at(objects, {2, 10}), half_over(blue, red), 1e-6);
}

// Each sample is blended with its own colour. So a pixel on the edge of an opaque triangle is, through a sheet, half of
// the sheet and half of the same pixel without it.
TEST(Blending, EverySampleHasItsOwnDestination) {
  const std::string edge = "triangle { vertices = [(-9, -9, 5), (-7, 18, 5), (1.3, -9, 5)]  color = red }\n",
                    sheet = "triangle { vertices = [(-9, -9, 3), (0, 18, 3), (9, -9, 3)]  color = blue  "
                            "transparency = 0.5 }\n";
  int mixed = 0;
  for (int column = 0; column < 20; ++column) {
    const Vec3d without = colour_at(edge, {column, 10}, 8);
    mixed += without.y > 0 && without.y < 1 ? 1 : 0;
    expect_near(colour_at(edge + sheet, {column, 10}, 8), half_over(blue, without), 1e-6);
  }
  EXPECT_GT(mixed, 0);
}

TEST(Blending, SortedShowsWhatRaysSee) {
  const Sheets sheets;
  const Image<Vec3f> rays = sheets.draw({"renderer=ray-tracer"});
  const auto differing = [&](const char* blending, int first, int last) {
    const Image<Vec3f> drawn = sheets.draw({blending});
    int count = 0;
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = first; x < last; ++x) {
        const Vec3f d = drawn.at(x, y) - rays.at(x, y);
        count += std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > 1e-6f;
      }
    return count;
  };
  EXPECT_EQ(differing("blending=sorted", 0, 400), 0);
  EXPECT_EQ(differing("blending=draw-order", 0, 200), 0);
  EXPECT_GT(differing("blending=draw-order", 200, 400), 10000) << "front to back";
  EXPECT_GT(differing("blending=off", 0, 400), 20000);
  EXPECT_GT(differing("blending=sorted", 400, 600), 1000) << "no order of whole triangles is right where they cross";
}

TEST(Blending, DoesNotDependOnThreads) {
  const Sheets sheets;
  for (const char* blending : {"blending=sorted", "blending=draw-order"}) {
    const Image<Vec3f> one = sheets.draw({blending, "threads=1"});
    for (const char* threads : {"threads=2", "threads=7"}) EXPECT_EQ(sheets.draw({blending, threads}), one);
    EXPECT_EQ(sheets.draw({blending, "visibility=painter"}).at(310, 180),
              sheets.draw({"blending=sorted"}).at(310, 180));
  }
}

TEST(Blending, StorySaysSourceDestinationAndResult) {
  const Sheets sheets;
  for (const char* multisampling : {"multisampling=1", "multisampling=4"}) {
    SCOPED_TRACE(multisampling);
    const PixelStory story = sheets.story(front_to_back, {"blending=sorted", multisampling});
    const auto writes = events_of<WriteEvent>(story.events);
    ASSERT_EQ(writes.size(), 4u);
    const Vec3d sources[] = {white, red, green, blue};
    Vec3d destination = writes[0]->before;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(writes[i]->opacity, i == 0 ? 1 : 0.5);
      expect_near(writes[i]->shaded, sources[i], 0);
      expect_near(writes[i]->before, destination, 0);
      destination = i == 0 ? white : half_over(sources[i], destination);
      expect_near(writes[i]->after, destination, 0);
    }
    expect_near(story.linear, destination, 0);
    EXPECT_NE(story.verdict.find("it is blended with 3 earlier colours"), std::string::npos) << story.verdict;
    ASSERT_GE(story.ledger.size(), 4u);
    expect_near(story.ledger.front().value, 0.5 * blue, 0);
    EXPECT_NE(story.ledger.front().term.find("0.5 x colour"), std::string::npos) << story.ledger.front().term;
  }
}

// A sheet and an opaque triangle meet along an edge. In the pixels of that edge the sheet is blended with the
// background alone, although the pixel's first sample may be one that the triangle has.
TEST(Blending, StoryHasADestinationThatIsBlended) {
  const std::string left = "triangle { vertices = [(-9, 0, 5), (0.4, 30, 5), (-0.2, -30, 5)]  color = ",
                    right = "triangle { vertices = [(-0.2, -30, 5), (0.4, 30, 5), (9, 0, 5)]  color = ",
                    sheet = "blue  transparency = 0.5 }\n", opaque = "red }\n";
  for (const std::string& objects : {left + opaque + right + sheet, left + sheet + right + opaque}) {
    const Scene scene = parse_scene("background = white\n" + objects +
                                        "settings { renderer = rasterizer  lighting = off  blending = sorted }\n",
                                    "edge.scene", ".");
    Settings settings = settings_for(scene);
    settings.multisampling = 8;
    int of_both = 0;
    for (int row = 0; row < 20; ++row) {
      std::vector<WriteEvent> writes;
      for (const Event& event : inspect(scene, {scene.camera, 20, 20}, settings, {10, row}).events)
        if (const auto* write = std::get_if<WriteEvent>(&event.data)) writes.push_back(*write);
      if (writes.size() != 2) continue;
      ++of_both;
      expect_near(writes[1].before, white, 0);
      expect_near(writes[1].after, half_over(blue, white), 0);
    }
    EXPECT_GT(of_both, 10);
  }
}

// At the left edge of the near sheet half of the samples show it.
TEST(Blending, LedgerOfSamplesAddsUp) {
  const Sheets sheets;
  for (const int column : {139, 140, 141, 200}) {
    const PixelStory story =
        sheets.story({column, 180}, {"blending=sorted", "multisampling=8", "sample-position=corner"});
    Vec3d sum{0, 0, 0};
    for (const LedgerLine& line : story.ledger)
      if (line.level == 0 && line.term != "rounding of the sum") sum += line.value;
    expect_near(sum, story.linear, 1e-6);
  }
}

TEST(Blending, OpacityMapIsMultiplied) {
  const Scene scene = parse_scene("background = (51, 51, 51)\n"
                                  "texture { name = holes  generator = brick-heights  size = 32 }\n"
                                  "triangle {\n"
                                  "    vertices = ((-2, -2, 3), (0, 3, 3), (2, -2, 3))\n"
                                  "    uvs = ((0, 0), (0.5, 1), (1, 0))\n"
                                  "    color = yellow  transparency = 0.25  opacity_map = holes\n"
                                  "}\n"
                                  "settings { renderer = rasterizer  lighting = off  blending = sorted }\n",
                                  "holes.scene", ".");
  const Settings settings = settings_for(scene);
  const View view{scene.camera, 60, 60};
  const Image<Vec3f> picture = render(scene, view, settings, request_for(Channel::none)).colour;
  std::set<double> opacities;
  for (int y = 3; y < 60; y += 4)
    for (int x = 1; x < 60; x += 4) {
      const PixelStory story = inspect(scene, view, settings, {x, y});
      std::optional<double> map;
      for (const Event& event : story.events) {
        if (const auto* read = std::get_if<TextureEvent>(&event.data); read && read->use == TextureUse::opacity)
          map = read->result.x;
        const auto* write = std::get_if<WriteEvent>(&event.data);
        if (!write) continue;
        ASSERT_TRUE(map);
        EXPECT_NEAR(write->opacity, 0.75 * *map, 1e-6);
        expect_near(write->after, write->opacity * Vec3d(1, 1, 0) + (1 - write->opacity) * Vec3d(0.2), 1e-6);
        expect_near(Vec3d(picture.at(x, y)), write->after, 0);
        opacities.insert(write->opacity);
      }
    }
  EXPECT_GT(opacities.size(), 1u);
}

TEST(Blending, NamesWhatItActsWith) {
  const Sheets sheets;
  const SceneTraits traits = scene_traits(sheets.scene);
  const Settings sorted = sheets.with({"blending=sorted", "projection=perspective"});
  // Without SIMD every setting has the processor for its reason.
  if (no_simd_reason(sorted).empty()) {
    EXPECT_EQ(fast_path(sorted, traits, Channel::none).reason, "SIMD replaces colours: it needs blending = off");
    EXPECT_NE(fast_path(sheets.with({"blending=off", "projection=perspective"}), traits, Channel::none).reason,
              fast_path(sorted, traits, Channel::none).reason);
  }
  EXPECT_TRUE(inactive_reason(*find_option("early-depth"), sorted, traits).has_value());
  EXPECT_FALSE(inactive_reason(*find_option("blending"), sorted, traits).has_value());
  const Settings stencil = sheets.with({"blending=sorted", "shadows=stencil-depth-fail"});
  EXPECT_TRUE(inactive_reason(*find_option("blending"), stencil, traits).has_value());
  EXPECT_EQ(sheets.draw({"blending=sorted", "shadows=stencil-depth-fail"}),
            sheets.draw({"blending=off", "shadows=stencil-depth-fail"}));
}

}  // namespace
}  // namespace ps::blending_test
