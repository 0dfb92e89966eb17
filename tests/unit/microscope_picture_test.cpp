// The microscope never contradicts the picture: at random pixels of scenes in which triangles fight for them, under
// random depth formats, orders, coverage and cut-outs, each sample shows what the pixel's story says that it shows. So
// does a point beside it, which is the sample of another picture.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "inspect/microscope/microscope.h"
#include "math/conventions.h"
#include "obj_corpus.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "render/story/names.h"
#include "scene/scene_file.h"
#include "support/environment.h"
#include "support/random_settings.h"
#include "support/settings_with.h"

namespace ps::microscope_picture_test {
namespace {

using test::below;

constexpr int of_areas = 120, of_lines = 24;  ///< pixels of a side; so few that lines are met
/// What lies on top at a sample, in the terms of a story.
struct OnTop {
  enum class Kind { background, triangle, line, canvas_shape } kind = Kind::background;
  PixelId id;
};

/// By the events alone: of each sample of the pixel, what wrote it last.
std::vector<OnTop> written(const PixelStory& story, int samples) {
  std::vector<OnTop> all(static_cast<std::size_t>(samples));
  std::map<int, std::vector<double>> samples_of;  // that the fragment writes, by its event
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const Event& event = story.events[i];
    if (const auto* coverage = std::get_if<CoverageEvent>(&event.data)) samples_of[event.parent] = coverage->values;
    if (const auto* line = std::get_if<LineEvent>(&event.data))
      std::fill(all.begin(), all.end(), OnTop{OnTop::Kind::line, line->id});
    const auto* write = std::get_if<WriteEvent>(&event.data);
    if (!write) continue;
    const bool on_canvas = write->id.object < 0;
    const OnTop seen{on_canvas ? OnTop::Kind::canvas_shape : OnTop::Kind::triangle, write->id};
    if (samples == 1 || on_canvas)
      std::fill(all.begin(), all.end(), seen);
    else
      for (const double sample : samples_of[event.parent]) all.at(static_cast<std::size_t>(sample)) = seen;
  }
  return all;
}

bool says(const std::string& text, const OnTop& top, const Scene& scene) {
  const std::string name = primitive_name(scene, top.id);
  switch (top.kind) {
  case OnTop::Kind::background:
    return text == "the background";
  case OnTop::Kind::triangle:
    return text == name || text.find(name + ", its triangle ") == 0;
  case OnTop::Kind::line:
    return text == "a line" || text == "an edge of " + name || text == "a vertex of " + name;
  case OnTop::Kind::canvas_shape:
    return text.find(" on the canvas") != std::string::npos;
  }
  return false;
}

/// Walls with holes, one behind the other at nearly the same depth, and one that stands across them.
Scene holes(const test::ModelFolder& folder) {
  folder.write("cut.pgm", "P2 3 2 255 255 0 255 0 255 90\n");
  std::string text = "background = linear (0, 0, 1)\ntexture { name = t file = cut.pgm }\n"
                     "material { name = m color = red opacity_map = t }\nmaterial { name = n color = green }\n"
                     "light { type = ambient intensity = 1 }\n";
  const auto wall = [&](const char* name, const char* material, double left, double right) {
    text += fmt::format(
        "model {{ name = {0} material = {1} vertices = [(-2, -2, {2}), (-2, 2, {2}), (2, 2, {3}), (2, -2, {3})]\n"
        "  uvs = [(0, 1), (0, 0), (1, 0), (1, 1)]\n"
        "  triangles {{ 0 = {{ vertices = [0, 1, 2] uvs = [0, 1, 2] }} 1 = {{ vertices = [0, 2, 3] uvs = [0, 2, 3] }} "
        "}} }}\ninstance {{ model = {0} }}\n",
        name, material, left, right);
  };
  wall("front", "m", 2, 2.001);
  wall("second", "m", 2.0005, 2.0015);
  wall("across", "n", 1.9, 2.2);
  wall("back", "m", 2.002, 2.002);
  return parse_scene(text, "holes.scene", folder.path().string());
}

const std::vector<std::string_view> varied{
    "visibility",      "depth-value",   "depth-format",  "depth-bits",   "depth-reversed",  "backface-culling",
    "precision",       "multisampling", "coverage",      "fill-rule",    "edge-arithmetic", "subpixel-bits",
    "sample-position", "projection",    "interpolation", "textures",     "early-depth",     "deferred-shading",
    "light-passes",    "clipping",      "draw",          "tessellation", "camera-relative"};

Settings random_settings(const Scene& scene, std::mt19937& random) {
  Settings settings = settings_for(scene, Renderer::rasterizer);
  settings.far = below(random, 4) == 0 ? no_far_limit : 10000;
  for (const std::string_view key : varied) {
    const bool is_of_depth = key.substr(0, 5) == "depth";
    // Drawn lines hide all else, and a multisampled pixel is not compared with another sample's picture.
    const int one_in = is_of_depth ? 2 : key == "draw" ? 4 : key == "multisampling" ? 10 : 3;
    if (below(random, one_in) != 0) continue;
    const Option& option = *find_option(key);
    option.set(settings, test::random_value(option, random));
  }
  return settings;
}

bool cuts_out(const PixelStory& story) {
  return std::any_of(story.events.begin(), story.events.end(), [](const Event& event) {
    const auto* rejected = std::get_if<RejectEvent>(&event.data);
    return rejected && rejected->reason == RejectReason::cut_out;
  });
}

/// The options that decide which of several triangles a pixel shows, with each of their choices.
std::set<std::string> ways_to_decide(const Settings& settings) {
  std::set<std::string> ways;
  for (const char* key : {"visibility", "depth-value", "depth-format", "depth-reversed"})
    ways.insert(fmt::format("{}={}", key, option_text(*find_option(key), settings)));
  return ways;
}

/// The picture whose only sample lies at the corner of the pixel, where this one's lies at its centre, or the other way
/// round. Its triangles and their edges are the same.
Settings with_other_sample(Settings settings) {
  settings.sample_position =
      settings.sample_position == SamplePosition::corner ? SamplePosition::centre : SamplePosition::corner;
  settings.coverage = Coverage::edge_function;  // the microscope moves samples of no other strategy
  settings.edge_arithmetic = EdgeArithmetic::fixed;
  return settings;
}

TEST(MicroscopePicture, ShowsWhatTheStorySaysAtRandomPixels) {
  const unsigned seed = test::test_seed();
  std::mt19937 random(seed);
  const test::ModelFolder folder;
  const std::vector<Scene> scenes{load_scene("lab/z-fighting"), holes(folder), load_scene("cgfs/depth"),
                                  load_scene("lab/polygons"), load_scene("cgfs/shading")};
  std::map<OnTop::Kind, int> seen;
  std::map<std::string, int> decided;  // of contested pixels, by what decides about them
  int contested = 0, with_holes = 0, beside = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto number = static_cast<std::size_t>(i / 2);
    const Scene& scene = scenes[i % 2 == 0 ? number % 2 : number % scenes.size()];  // the first two are fought for
    const Settings settings = random_settings(scene, random);
    const int size = settings.draw == Draw::filled ? of_areas : of_lines;
    const View view{scene.camera, size, size};
    const Vec2i pixel(below(random, size), below(random, size));
    Prepared prepared;
    Progress progress;
    const PixelStory story = inspect(scene, view, settings, pixel, prepared, progress);
    const Microscope scope(scene, view, settings, pixel, prepared, progress, MicroDetail::first);
    const std::string words = fmt::format("seed {}, {} at {},{}, options{}", seed, scene.name, pixel.x, pixel.y,
                                          test::changed_settings(settings));
    const int samples = settings.draw != Draw::filled ? 1 : static_cast<int>(scope.samples().size());
    const std::vector<OnTop> tops = written(story, samples);
    for (std::size_t s = 0; s < scope.samples().size(); ++s) {
      const OnTop& top = tops[std::min(s, tops.size() - 1)];
      const MicroSample& sample = scope.samples()[s];
      EXPECT_TRUE(says(sample.seen, top, scene))
          << words << "\nsample " << s << " shows " << sample.seen << ", " << story.verdict;
      EXPECT_EQ(sample.lit, top.kind != OnTop::Kind::background) << words;
      ++seen[top.kind];
    }
    if (scope.samples().size() > 1) continue;
    const MicroReading reading = scope.read(scope.samples()[0].position, prepared, progress);
    EXPECT_TRUE(says(reading.seen, tops[0], scene)) << words << "\nread as " << reading.seen << ", " << story.verdict;
    int covering = 0;
    for (const MicroTriangle& triangle : reading.triangles) covering += triangle.covered ? 1 : 0;
    with_holes += cuts_out(story) ? 1 : 0;
    if (covering > 1) {
      ++contested;
      for (const std::string& way : ways_to_decide(settings)) ++decided[way];
    }
    if (i % 2 != 0 || settings.draw != Draw::filled) continue;
    const Settings other = with_other_sample(settings);
    const Vec2d moved = other.sample_position == SamplePosition::corner ? sample_at_book_corner : sample_at_centre;
    const OnTop there = written(inspect(scene, view, other, pixel, prepared, progress), 1)[0];
    const MicroReading point = scope.read(moved, prepared, progress);
    EXPECT_TRUE(says(point.seen, there, scene)) << words << "\nat " << moved.x << "," << moved.y << " " << point.seen;
    beside += point.seen != reading.seen ? 1 : 0;
  }
  fmt::print("seed {}: {} pixels contested, {} with holes, {} with another triangle beside the sample\n", seed,
             contested, with_holes, beside);
  EXPECT_GT(decided["depth-reversed=on"], 10) << "seed " << seed;
  for (const char* key : {"visibility", "depth-value", "depth-format"})
    for (const Choice& choice : find_option(key)->choices)
      EXPECT_GT(decided[fmt::format("{}={}", key, choice.key)], 10) << key << " " << choice.key << ", seed " << seed;
  EXPECT_GT(with_holes, 30) << "seed " << seed;
  EXPECT_GT(beside, 0) << "seed " << seed;
  EXPECT_GT(contested, 150) << "seed " << seed;
  EXPECT_GT(seen[OnTop::Kind::background], 50) << "seed " << seed;
  EXPECT_GT(seen[OnTop::Kind::triangle], 400) << "seed " << seed;
  EXPECT_GT(seen[OnTop::Kind::line], 2) << "seed " << seed;
  EXPECT_GT(seen[OnTop::Kind::canvas_shape], 5) << "seed " << seed;
}

}  // namespace
}  // namespace ps::microscope_picture_test
