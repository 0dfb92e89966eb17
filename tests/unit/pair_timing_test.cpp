// Two renders timed in turn: which runs count, and what becomes of their times. The clock is ours.
#include "study/pair_timing.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "scene/load.h"

namespace ps::pair_timing_test {
namespace {

/// Two pictures whose calls take the times they are given, the last one from then on.
struct Fake {
  double now = 0;
  std::string order;
  std::array<std::vector<double>, 2> seconds;
  std::array<std::size_t, 2> made{};

  TimedCall call(std::size_t side) {
    return [this, side] {
      const double taken = seconds[side][std::min(made[side], seconds[side].size() - 1)];
      ++made[side];
      now += taken;
      order += side == 0 ? 'a' : 'b';
      return std::vector<StageTime>{{side == 0 ? "rays" : "fragments", 1e3 * taken}};
    };
  }
  PairTiming run(const PairTimingOptions& options, const PairTimingUpdate& update = {}) {
    StudyControl control;
    return time_in_turn({call(0), call(1)}, options, control, update, [this] { return now; });
  }
};

TEST(PairTiming, TheFirstRunsDoNotCount) {
  Fake fake;
  fake.seconds = {{{5, 0.25}, {0.5, 1}}};  // the first picture is cold once, the second one warm
  const PairTiming timing = fake.run({.rounds = 4, .longest = 1000});
  EXPECT_EQ(timing.time_ms[0].median, 250);
  EXPECT_EQ(timing.time_ms[1].median, 1000);
  EXPECT_EQ(timing.ratio.median, 4);
  EXPECT_EQ(timing.rounds(), 4);
  // Once to warm up, as both are long; then an untimed and a timed run each, in turn.
  EXPECT_EQ(fake.order, "ab"
                        "aabb"
                        "bbaa"
                        "aabb"
                        "bbaa");
}

TEST(PairTiming, AMachineThatSlowsDownSlowsBoth) {
  Fake fake;
  for (int i = 0; i < 30; ++i) {
    fake.seconds[0].push_back(1 + 0.1 * i);
    fake.seconds[1].push_back(2 + 0.2 * i);
  }
  const PairTiming timing = fake.run({.rounds = 9, .longest = 1000});
  EXPECT_GT(timing.time_ms[0].q3, 1.3 * timing.time_ms[0].q1);
  EXPECT_NEAR(timing.ratio.median, 2, 1e-9);
  EXPECT_NEAR(timing.ratio.q1, timing.ratio.q3, 1e-9);
}

TEST(PairTiming, ShortRunsAreRepeatedWithinASample) {
  Fake fake;
  fake.seconds = {{{0.001}, {0.1}}};
  const PairTiming timing = fake.run({.rounds = 3, .shortest_sample = 0.01});
  EXPECT_NEAR(timing.time_ms[0].median, 1, 1e-9);
  EXPECT_NEAR(timing.time_ms[1].median, 100, 1e-9);
  EXPECT_GT(fake.made[0], 3u * 10);
}

TEST(PairTiming, LongRunsGetFewerRounds) {
  Fake fake;
  fake.seconds = {{{10}, {10}}};
  EXPECT_EQ(fake.run({.rounds = 9, .fewest_rounds = 3, .longest = 20}).rounds(), 3);
}

TEST(PairTiming, StagesHaveTheMedianOfTheTimedRuns) {
  Fake fake;
  fake.seconds = {{{9, 0.25}, {9, 0.5}}};
  const PairTiming timing = fake.run({.rounds = 3, .longest = 1000});
  ASSERT_EQ(timing.stages.size(), 2u);
  EXPECT_EQ(timing.stages[0].stage, "rays");
  EXPECT_EQ(timing.stages[0].median_ms[0], 250);
  EXPECT_FALSE(timing.stages[0].median_ms[1]);
  EXPECT_EQ(timing.stages[1].median_ms[1], 500);
}

TEST(PairTiming, ReportsEverySampleAndStopsWhenAsked) {
  Fake fake;
  fake.seconds = {{{1}, {2}}};
  std::vector<int> done;
  double left = -1;
  fake.run({.rounds = 3, .longest = 1000}, [&](const StudyStatus& status) {
    done.push_back(status.done);
    if (status.done == 4) left = status.seconds_left;
    EXPECT_EQ(status.total, 6);
  });
  EXPECT_EQ(done, (std::vector<int>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(left, 6) << "two more samples of 2 s and 4 s with their untimed runs";
  StudyControl control;
  EXPECT_THROW(time_in_turn(
                   {fake.call(0), fake.call(1)}, {}, control,
                   [&](const StudyStatus& status) {
                     if (status.done == 3) control.cancel();
                   },
                   [&] { return fake.now; }),
               Cancelled);
}

TEST(PairTiming, EqualSettingsHaveNoOrder) {
  PairTimingRequest request;
  request.scene = load_scene("cgfs/reflections");
  request.view.width = request.view.height = 16;
  StudyControl control;
  const PairTiming same = time_pair(request, {.rounds = 3}, control);
  EXPECT_TRUE(same.equal_settings);
  EXPECT_FALSE(same.shows_an_order());
  request.settings[1].reflection_depth = 0;
  EXPECT_FALSE(time_pair(request, {.rounds = 3}, control).equal_settings);
  Fake fake;
  fake.seconds = {{{1}, {1.09}}};
  EXPECT_FALSE(fake.run({.rounds = 3}).shows_an_order()) << "below a tenth";
  fake = {};
  fake.seconds = {{{1}, {1.2}}};
  EXPECT_TRUE(fake.run({.rounds = 3}).shows_an_order());
}

TEST(PairTiming, TimesPicturesOfAScene) {
  PairTimingRequest request;
  request.scene = load_scene("cgfs/reflections");
  request.view.width = request.view.height = 24;
  request.settings[1].renderer = Renderer::rasterizer;
  StudyControl control;
  const PairTiming timing = time_pair(request, {.rounds = 3}, control);
  EXPECT_EQ(timing.rounds(), 3);
  for (const Quartiles& time : timing.time_ms) EXPECT_GT(time.q1, 0);
  EXPECT_FALSE(timing.stages.empty());
}

}  // namespace
}  // namespace ps::pair_timing_test
