// What a story shows of triangles on the canvas that a pixel lies on the side of: CGFS ch. 7, and the fill rule.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "inspect/describe.h"
#include "inspect/microscope/microscope.h"
#include "options/scene_settings.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::canvas_story_test {
namespace {

/// The two triangles of a square, whose shared edge runs through the sample of pixel (20, 19).
struct Square {
  Scene scene = load_scene("chapters/cgfs_07_filled_triangles/square.scene");

  PixelStory inspect_with(FillRule rule) const {
    Settings settings = settings_for(scene, Renderer::rasterizer);
    settings.sample_position = SamplePosition::corner;
    settings.fill_rule = rule;
    return inspect(scene, {scene.camera, scene.canvas_width, scene.canvas_height}, settings, {20, 19});
  }
};

TEST(CanvasStory, ASideThatNobodyOwnsIsRefusedByBoth) {
  const Square square;
  const PixelStory story = square.inspect_with(FillRule::exclusive);
  EXPECT_EQ(events_of<FragmentEvent>(story.events).size(), 0u);
  const auto refused = events_of<RejectEvent>(story.events);
  ASSERT_EQ(refused.size(), 2u);
  for (const auto* reject : refused) {
    EXPECT_EQ(reject->reason, RejectReason::not_covered);
    EXPECT_NE(reject->detail.find("does not own"), std::string::npos) << reject->detail;
    ASSERT_TRUE(reject->edges);
    int zeros = 0;
    for (const double edge : *reject->edges) zeros += edge == 0 ? 1 : 0;
    EXPECT_EQ(zeros, 1) << "the sample lies on one side, and inside the two others";
    EXPECT_EQ(describe({-1, *reject}, square.scene).find("a triangle on the canvas"), 0u);
  }
}

TEST(CanvasStory, WithTheRuleOneTakesItAndTheOtherGivesItUp) {
  const Square square;
  const PixelStory story = square.inspect_with(FillRule::top_left);
  EXPECT_EQ(events_of<FragmentEvent>(story.events).size(), 1u);
  EXPECT_EQ(events_of<RejectEvent>(story.events).size(), 1u);
  const PixelStory all = square.inspect_with(FillRule::inclusive);
  EXPECT_EQ(events_of<FragmentEvent>(all.events).size(), 2u);
  EXPECT_TRUE(events_of<RejectEvent>(all.events).empty());
}

// The microscope shows what the story shows: the sample on the side of both, and who owns it.
TEST(CanvasStory, TheMicroscopeShowsTheTriangles) {
  const Square square;
  Settings settings = settings_for(square.scene, Renderer::rasterizer);
  settings.sample_position = SamplePosition::corner;
  for (const auto& [rule, owners] :
       {std::pair{FillRule::exclusive, 0}, {FillRule::top_left, 1}, {FillRule::inclusive, 2}}) {
    settings.fill_rule = rule;
    Prepared prepared;
    Progress progress;
    const View view{square.scene.camera, square.scene.canvas_width, square.scene.canvas_height};
    const Microscope scope(square.scene, view, settings, {20, 19}, prepared, progress);
    const MicroReading reading = scope.read({0, 1}, prepared, progress);  // the lower left corner
    ASSERT_EQ(reading.triangles.size(), 2u);
    int covered = 0;
    for (const MicroTriangle& triangle : reading.triangles) {
      EXPECT_EQ(std::count(triangle.ties.begin(), triangle.ties.end(), true), 1);
      EXPECT_DOUBLE_EQ(triangle.weights_2d[0] + triangle.weights_2d[1] + triangle.weights_2d[2], 1);
      covered += triangle.covered ? 1 : 0;
    }
    EXPECT_EQ(covered, owners);
    EXPECT_EQ(reading.front >= 0, owners > 0);
    ASSERT_EQ(scope.samples().size(), 1u);
    EXPECT_EQ(scope.samples()[0].lit, owners > 0);
    // The side runs through the pixel from corner to corner: the picture has one colour above it and another below.
    const auto& picture = scope.enlarged();
    const int side = picture.width();
    EXPECT_EQ(picture.at(side / 4, side / 4), (Rgb8{0, 0, 255}));
    EXPECT_EQ(picture.at(side * 3 / 4, side * 3 / 4), (Rgb8{0, 255, 0}));
  }
}

}  // namespace
}  // namespace ps::canvas_story_test
