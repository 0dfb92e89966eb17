// How long a study will take, before it starts.
#include "study/estimate.h"

#include <gtest/gtest.h>

#include "options/scene_settings.h"
#include "scene/load.h"

namespace ps::estimate_test {
namespace {

ChartRequest request_of(const std::vector<std::string>& sweeps) {
  ChartRequest request;
  request.scene = load_scene("cgfs/reflections");
  request.view = {request.scene.camera, 96, 96};
  request.base = settings_for(request.scene);
  std::vector<SweepAxis> axes;
  for (const std::string& sweep : sweeps) axes.push_back(parse_sweep_axis(sweep));
  request.points = sweep_points(axes, request.base, request.base, scene_traits(request.scene));
  return request;
}

/// A clock on which every reading is a step later, so that every timed piece of work takes one step.
Clock stepping(double step) {
  return [now = 0.0, step]() mutable { return now += step; };
}

TEST(Estimate, CountsThePicturesOfTheShard) {
  StudyControl control;
  ChartRequest request = request_of({"reflection-depth=0,1,2"});
  EXPECT_EQ(estimate_chart(request, control, stepping(0.01)).pictures, 3);
  request.shard = {0, 2};
  EXPECT_EQ(estimate_chart(request, control, stepping(0.01)).pictures, 2);
}

TEST(Estimate, GrowsWithRunsAndWithTheTimeOfAPicture) {
  StudyControl control;
  ChartRequest request = request_of({"reflection-depth=0,1"});
  request.shortest_sample = 0;
  const double five = estimate_chart(request, control, stepping(0.01)).seconds;
  request.repeats = 10;
  const double ten = estimate_chart(request, control, stepping(0.01)).seconds;
  // Five more runs of two points, each with one run before it that is not timed. Every try takes a step whatever its
  // size, so a picture of 96 x 96 pixels takes as many steps as it has times the 64 x 64 of the larger try.
  EXPECT_NEAR(ten - five, 5 * 2 * 2 * 0.01 * (96.0 * 96) / (64 * 64), 1e-9);
  EXPECT_NEAR(estimate_chart(request, control, stepping(0.02)).seconds, 2 * ten, 1e-9);
}

TEST(Estimate, NeedsCountFeaturesAndSavings) {
  StudyControl control;
  NeedsRequest request;
  request.scene = load_scene("cgfs/reflections");
  request.view = {request.scene.camera, 64, 64};
  request.base = settings_for(request.scene);
  const SceneTraits traits = scene_traits(request.scene);
  int used = 0;
  for (const Feature& feature : features()) used += unused_reason(feature, request.base, traits) ? 0 : 1;
  const NeedsEstimate estimate = estimate_needs(request, control, stepping(0.01));
  EXPECT_EQ(estimate.round.pictures, static_cast<int>(savings(request.base, traits).size()));
  EXPECT_EQ(estimate.least.pictures, 1 + used + estimate.round.pictures);
  EXPECT_GT(estimate.least.seconds, estimate.round.seconds);
}

TEST(Estimate, IsRoundedInWords) {
  EXPECT_EQ(about_seconds(0.4), "under a second");
  EXPECT_EQ(about_seconds(3.4), "about 3 s");
  EXPECT_EQ(about_seconds(42), "about 40 s");
  EXPECT_EQ(about_seconds(170), "about 3 min");
  EXPECT_EQ(about_seconds(9000), "about 2.5 h");
  EXPECT_EQ(estimate_text({1, 2}), "about 2 s, 1 picture");
  EXPECT_EQ(estimate_text({20, 41}), "about 40 s, 20 pictures");
}

}  // namespace
}  // namespace ps::estimate_test
