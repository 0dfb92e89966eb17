// What stands below a picture: counted work before times, and no time that could mislead. All times are given here.
#include "gui/panels/pictures/caption.h"

#include <gtest/gtest.h>

#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/studies/timings_tab.h"
#include "gui/session/timed_pictures.h"
#include "options/option.h"

namespace ps::gui::caption_test {
namespace {

using namespace std::chrono_literals;

std::shared_ptr<RenderResult> rasterized(std::uint64_t triangles, std::uint64_t fragments) {
  auto result = std::make_shared<RenderResult>();
  result->request.settings.renderer = Renderer::rasterizer;
  result->request.scene.name = "scene";
  result->frame.counters[Counter::triangles_drawn] = triangles;
  result->frame.counters[Counter::fragments] = fragments;
  return result;
}

std::string texts(const CaptionChange& change, const RenderResult& result, double now) {
  std::string all;
  for (const CaptionWork& work : caption_work(result)) all += work_text(work, change.before(work, now)) + "|";
  return all;
}

TEST(Caption, CountsWork) {
  EXPECT_EQ(work_text({37, "triangle"}), "37 triangles");
  EXPECT_EQ(work_text({1, "ray"}), "1 ray");
  EXPECT_EQ(work_text({37, "triangle"}, 19), "19 → 37 triangles");
  const auto result = rasterized(3, 5);
  result->frame.counters[Counter::nan_pixels] = 2;
  const auto work = caption_work(*result);
  ASSERT_EQ(work.size(), 3u);
  EXPECT_TRUE(work[0].attention) << "pixels that are not a number come first";
  EXPECT_EQ(work_text(work[0]), "2 NaN pixels");
  EXPECT_EQ(work_text(work[2]), "5 fragments");
  result->request.settings.renderer = Renderer::ray_tracer;
  for (const Counter rays :
       {Counter::eye_rays, Counter::shadow_rays, Counter::reflection_rays, Counter::refraction_rays})
    result->frame.counters[rays] = 10;
  EXPECT_EQ(work_text(caption_work(*result)[1]), "40 rays") << "all kinds of them";
}

TEST(Caption, CountsWhatADriverWasGiven) {
  const auto result = rasterized(3, 5);
  result->frame.counters[Counter::triangles_in] = 12;
  result->frame.counters.given = {Counter::triangles_in, Counter::nan_pixels};
  const auto work = caption_work(*result);
  ASSERT_EQ(work.size(), 1u) << "fragments are not counted";
  EXPECT_EQ(work_text(work[0]), "12 submitted triangles");
}

TEST(Caption, WarmRunsHaveTheirSpread) {
  EXPECT_EQ(warm_time_text({22.91, 23.46, 24.44}), "23.5 ms (22.9 to 24.4)");
  EXPECT_EQ(warm_time_text({1290, 1310, 1450}), "1.31 s (1.29 to 1.45)");
  EXPECT_EQ(warm_time_text({0.41, 0.42, 0.5}), "0.42 ms (0.41 to 0.50)");
}

TEST(Caption, OldCountsAreShownForSomeSeconds) {
  CaptionChange change;
  const auto first = rasterized(19, 100), second = rasterized(37, 100), third = rasterized(40, 100);
  change.take(first, 1);
  EXPECT_EQ(texts(change, *first, 1), "19 triangles|100 fragments|");
  EXPECT_EQ(change.left(1), 0);
  change.take(second, 10);
  EXPECT_EQ(texts(change, *second, 10), "19 → 37 triangles|100 fragments|");
  change.take(second, 12);
  EXPECT_GT(change.left(12), 0);
  EXPECT_EQ(texts(change, *second, 10.01 + CaptionChange::shown_for), "37 triangles|100 fragments|");
  EXPECT_EQ(change.left(10.01 + CaptionChange::shown_for), 0);
  // Pictures in quick succession are one change: of a drag, from where it began.
  change.take(first, 30);
  change.take(second, 30.2);
  change.take(third, 30.4);
  EXPECT_EQ(texts(change, *third, 30.4), "37 → 40 triangles|100 fragments|");
}

TEST(Caption, NumbersThatAreShownAlikeAreNoChange) {
  CaptionChange change;
  const auto first = rasterized(19, 1'510'100), second = rasterized(20, 1'510'900);
  change.take(first, 1);
  change.take(second, 10);
  EXPECT_EQ(texts(change, *second, 10), "19 → 20 triangles|1.51 M fragments|");
}

TEST(Caption, OtherWorkOrAnotherSceneHasNoOldCount) {
  CaptionChange change;
  const auto first = rasterized(19, 100), traced = rasterized(0, 0), elsewhere = rasterized(5, 6);
  traced->request.settings.renderer = Renderer::ray_tracer;
  elsewhere->request.scene.name = "another";
  change.take(first, 1);
  change.take(traced, 10);
  EXPECT_EQ(texts(change, *traced, 10), "0 rays|");
  change.take(first, 20);
  EXPECT_EQ(texts(change, *first, 20), "19 triangles|100 fragments|");
  change.take(elsewhere, 30);
  EXPECT_EQ(texts(change, *elsewhere, 30), "5 triangles|6 fragments|");
}

TEST(TimedPictures, AreFoundWhenTheSamePictureComesBack) {
  TimedPictures timed;
  PictureRequest request;
  EXPECT_EQ(timed.find(request), nullptr);
  timed.add({request, {1, 2, 3}, 9});
  ASSERT_NE(timed.find(request), nullptr);
  PictureRequest other = request;
  parse_assignment("exposure=2", other.settings);
  EXPECT_NE(timed.find(other), nullptr) << "only displayed otherwise";
  parse_assignment("shading=flat", other.settings);
  EXPECT_EQ(timed.find(other), nullptr);
  other = request;
  other.shown = ShownChannel::depth;
  EXPECT_EQ(timed.find(other), nullptr) << "another channel is other work";
  timed.add({request, {4, 5, 6}, 9});
  EXPECT_EQ(timed.find(request)->ms.median, 5) << "the newest";
  for (int size = 1; size < 100; ++size) {
    other = request;
    other.view.width = size;
    timed.add({other, {7, 8, 9}, 3});
  }
  EXPECT_NE(timed.find(other), nullptr);
  EXPECT_EQ(timed.find(request), nullptr) << "long ago";
}

/// As if A had taken 100 ms in every round.
PairTiming with_ratio(const Quartiles& ratio) {
  PairTiming timing;
  timing.ratio = ratio;
  timing.time_ms = {Quartiles{100, 100, 100}, Quartiles{100 * ratio.q1, 100 * ratio.median, 100 * ratio.q3}};
  timing.samples_ms[1].assign(9, 1);
  return timing;
}

TEST(Timings, RatioHasItsRangeAndNoMoreDigitsThanItIsWorth) {
  EXPECT_EQ(ratio_sentence(with_ratio({4.412, 4.634, 4.913})),
            "B takes 4.6 times as long as A (4.4 to 4.9; 9 rounds).");
  EXPECT_EQ(ratio_sentence(with_ratio({0.2, 0.25, 0.5})), "A takes 4 times as long as B (2 to 5; 9 rounds).");
}

TEST(Timings, NoOrderIsFoundWithinNoise) {
  EXPECT_EQ(ratio_sentence(with_ratio({0.97, 1.02, 1.06})),
            "The times of A and B are equal within noise: B / A is 1 (0.97 to 1.1; 9 rounds).");
  for (const Quartiles& ratio : {Quartiles{1.02, 1.04, 1.08}, Quartiles{1, 1.2, 1.3}, Quartiles{0.93, 0.95, 0.97}})
    EXPECT_TRUE(ratio_sentence(with_ratio(ratio)).starts_with("The times of A and B are equal within noise"));
  PairTiming drifting = with_ratio({1.3, 1.4, 1.5});
  drifting.time_ms[0].q3 = drifting.time_ms[1].q1;
  EXPECT_TRUE(ratio_sentence(drifting).starts_with("The times of A and B are equal within noise")) << "they touch";
  PairTiming equal = with_ratio({1.1, 1.4, 1.8});
  equal.equal_settings = true;
  EXPECT_EQ(ratio_sentence(equal),
            "The options of A and B are equal, and times differ by noise alone: B / A is 1.4 (1.1 to 1.8; 9 rounds).");
}

TEST(Timings, SmallNumbersOfDigits) {
  EXPECT_EQ(two_digits(268.4), "270");
  EXPECT_EQ(two_digits(9.96), "10");
  EXPECT_EQ(two_digits(0.0412), "0.041");
  EXPECT_EQ(three_digits(0.4167), "0.42");
  EXPECT_EQ(three_digits(14.23), "14.2");
  EXPECT_EQ(three_digits(131.4), "131");
}

}  // namespace
}  // namespace ps::gui::caption_test
