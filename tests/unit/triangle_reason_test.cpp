// Why a triangle that a ray's line meets is no hit: the reason in words against the number beside it.
#include <gtest/gtest.h>

#include "record/events.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::triangle_reason_test {
namespace {

// Shadow rays start on the far side of their own cube: it has triangles behind them, too.
TEST(TriangleReason, WhatLiesBehindARayIsNotARoundingError) {
  const Scene scene = load_scene("cgfs/crates");
  const PixelStory story = inspect(scene, {scene.camera, 600, 600}, Settings{}, {340, 130});
  int behind = 0;
  for (const auto* test : events_of<TriangleTestEvent>(story.events)) {
    if (test->outcome != TestOutcome::before_range || !test->t) continue;
    if (*test->t < -0.1) {
      ++behind;
      EXPECT_EQ(test->rejected_by, "") << "t = " << *test->t;
    }
  }
  EXPECT_GT(behind, 0);
}

}  // namespace
}  // namespace ps::triangle_reason_test
