// Why a triangle that a ray's line meets is no hit: the reason in words against the number beside it.
#include <gtest/gtest.h>

#include "record/events.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps {
namespace triangle_reason_test {
namespace {

// Shadow rays start on the far side of their own cube: it has triangles behind them, too.
TEST(TriangleReason, WhatLiesBehindARayIsNotARoundingError) {
  const Scene scene = load_scene("cgfs/crates");
  const PixelStory story = inspect(scene, {scene.camera, 600, 600}, Settings{}, {340, 130});
  int behind = 0;
  for (const Event& event : story.events) {
    const auto* test = std::get_if<TriangleTestEvent>(&event.data);
    if (!test || test->outcome != TestOutcome::before_range || !test->t) continue;
    if (*test->t < -0.1) {
      ++behind;
      EXPECT_EQ(test->rejected_by, "") << "t = " << *test->t;
    }
  }
  EXPECT_GT(behind, 0);
}

}  // namespace
}  // namespace triangle_reason_test
}  // namespace ps
