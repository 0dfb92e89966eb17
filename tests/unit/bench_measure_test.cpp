#include <gtest/gtest.h>

#include "bench/measure.h"

namespace ps::bench_measure_test {
namespace {
using namespace ps::bench;

/// A clock that only moves when a call says so.
struct FakeTime {
  double now = 0;
  Clock clock() {
    return [this] { return now; };
  }
  std::function<void()> call(double seconds) {
    return [this, seconds] { now += seconds; };
  }
};

TEST(BenchMeasure, ReportsMillisecondsOfOneCallOfEachSide) {
  FakeTime time;
  const Timing timing = measure(time.call(0.002), time.call(0.5), {.repeats = 5, .budget = 100}, time.clock());
  EXPECT_NEAR(timing.ours.median, 2, 1e-9);
  EXPECT_NEAR(timing.yardstick.median, 500, 1e-9);
  EXPECT_EQ(timing.repeats, 5);
}

TEST(BenchMeasure, AnOutlierDoesNotMoveTheMedianAndTheFirstCallIsNotCounted) {
  FakeTime time;
  int calls = 0;
  const auto ours = [&] { time.now += ++calls == 1 ? 100.0 : calls == 4 ? 9.0 : 0.01; };
  const Timing timing = measure(ours, {}, {.repeats = 7, .budget = 1000}, time.clock());
  EXPECT_NEAR(timing.ours.median, 10, 1e-9);
  EXPECT_NEAR(timing.ours.q3, 10, 1e-9);
}

TEST(BenchMeasure, SidesTakeTurnsAndAlternateWhoGoesFirst) {
  FakeTime time;
  std::string order;
  bool record = false;
  const Clock clock = [&] { return time.now; };
  const auto side = [&](char name) {
    return [&, name] {
      time.now += 1;
      if (record) order += name;
      if (name == 'y' && time.now > 1.5) record = true;  // both have been warmed up
    };
  };
  measure(side('o'), side('y'), {.repeats = 4, .budget = 100}, clock);
  EXPECT_EQ(order, "oyyooyyo");
}

TEST(BenchMeasure, ShortCallsFillASampleAndTheBudgetLimitsRepeats) {
  FakeTime time;
  int calls = 0;
  const auto ours = [&] {
    ++calls;
    time.now += 0.001;
  };
  measure(ours, {}, {.repeats = 1, .fewest_repeats = 1, .shortest_sample = 0.0079}, time.clock());
  EXPECT_EQ(calls, 1 + (1 + 2 + 4 + 8) + 8);
  const Timing slow = measure(time.call(2), {}, {.repeats = 50, .fewest_repeats = 3, .budget = 7}, time.clock());
  EXPECT_EQ(slow.repeats, 4);
}

}  // namespace
}  // namespace ps::bench_measure_test
