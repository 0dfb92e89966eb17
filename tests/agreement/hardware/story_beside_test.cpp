// The story of a hardware pixel stands beside that of the rasterizer: where they part has a reason, and what a driver
// does not report is absent.
#include <gtest/gtest.h>

#include <random>

#include "agreement/hardware/hardware_pair.h"
#include "inspect/microscope/microscope.h"
#include "inspect/parting/align_stories.h"
#include "inspect/parting/parting.h"
#include "inspect/story_json.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/provenance.h"
#include "render/render.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/environment.h"

namespace ps::hardware_story_beside_test {
namespace {

constexpr int side = 200, pixels_of_scene = 12;

struct Beside {
  Scene scene;
  View view;
  Settings a, b;  ///< rasterizer, hardware
  Prepared prepared;
  Progress progress;

  Beside(const char* name, Renderer hardware, const std::vector<std::string>& assignments)
      : scene(load_scene(name)), view{scene.camera, side, side}, a(settings_for(scene)) {
    for (const std::string& assignment : assignments) parse_assignment(assignment, a);
    b = a;
    a.renderer = Renderer::rasterizer;
    b.renderer = hardware;
  }
  PixelStory story(const Settings& settings, Vec2i pixel) {
    return inspect(scene, view, settings, pixel, prepared, progress);
  }
};

struct BesideCase {
  const char* scene;
  std::vector<std::string> assignments;
};
const std::vector<BesideCase> cases{{"cgfs/shading", {}},
                                    {"cgfs/shadows", {"shadows=stencil-depth-fail"}},
                                    {"cgfs/crates", {}},
                                    {"cgfs/reflections", {"environment=cube-map"}},
                                    {"cgpp/teapot", {"shading=gouraud"}},
                                    {"lab/cornell", {"light-passes=many"}}};

TEST(HardwareStoryBeside, PartsFromTheRasterizersForAReason) {
  PS_NEEDS_HARDWARE(hardware);
  const unsigned seed = test::test_seed(5);
  std::mt19937 random(seed);
  int differ = 0;
  for (const BesideCase& one : cases) {
    Beside beside(one.scene, hardware, one.assignments);
    for (int i = 0; i < pixels_of_scene; ++i) {
      const int x = static_cast<int>(random() % side);
      const Vec2i pixel(x, static_cast<int>(random() % side));
      const PixelStory of_a = beside.story(beside.a, pixel), of_b = beside.story(beside.b, pixel);
      const Parting parting = find_parting(beside.scene, {of_a, beside.a}, {of_b, beside.b});
      EXPECT_NE(parting.cause, PartingCause::unexplained)
          << one.scene << " " << pixel.x << "," << pixel.y << " seed " << seed << ": " << parting.sentence;
      EXPECT_EQ(parting.sentence.find("ray"), std::string::npos) << parting.sentence;
      differ += parting.cause != PartingCause::none;
      // What is seen has a partner on the other side.
      int paired = 0;
      for (const AlignedRow& row : align_stories(of_a, of_b, beside.scene)) paired += row.a >= 0 && row.b >= 0;
      EXPECT_GT(paired, 0) << one.scene;
    }
  }
  EXPECT_GT(differ, 0) << "nothing was compared";
}

TEST(HardwareStoryBeside, WhatADriverDoesNotReportIsAbsent) {
  PS_NEEDS_HARDWARE(hardware);
  Beside beside("lab/cornell", hardware, {});
  int fragments = 0;
  for (int x = 20; x < side; x += 20) {
    const PixelStory story = beside.story(beside.b, {x, side / 2});
    EXPECT_FALSE(story.not_reported.empty());
    for (const auto* reject : events_of<RejectEvent>(story.events)) EXPECT_FALSE(reject->edges);
    for (const auto* fragment : events_of<FragmentEvent>(story.events)) {
      ++fragments;
      EXPECT_FALSE(fragment->edges || fragment->tie_owned || fragment->clipped_into);
    }
    const std::string json = story_json(story, beside.scene, beside.view, Provenance{});
    EXPECT_EQ(json.find("\"edges\""), std::string::npos);
    EXPECT_NE(json.find("\"not-reported\""), std::string::npos);
  }
  EXPECT_GT(fragments, 0);
}

/// Its numbers at other points of the pixel are the driver's, or none.
TEST(HardwareStoryBeside, TheMicroscopeShowsNoTrianglesOfTheRasterizer) {
  PS_NEEDS_HARDWARE(hardware);
  Beside beside("lab/cornell", hardware, {});
  const Vec2i pixel(side / 2, side / 2);
  const Microscope scope(beside.scene, beside.view, beside.b, pixel, beside.prepared, beside.progress);
  ASSERT_EQ(scope.samples().size(), 1u);
  const MicroReading reading = scope.read({0.25, 0.75}, beside.prepared, beside.progress);
  EXPECT_TRUE(reading.triangles.empty());
  ASSERT_TRUE(reading.ray);
  EXPECT_EQ(reading.ray->renderer, hardware);
  EXPECT_FALSE(reading.seen.empty());
  const Microscope other(beside.scene, beside.view, beside.a, pixel, beside.prepared, beside.progress);
  EXPECT_FALSE(other.read({0.25, 0.75}, beside.prepared, beside.progress).triangles.empty());
}

}  // namespace
}  // namespace ps::hardware_story_beside_test
