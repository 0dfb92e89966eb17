#pragma once
#include <chrono>
#include <functional>

#include "bench/statistics.h"

namespace ps::bench {

/// Seconds since some fixed moment. Tests pass a clock of their own.
using Clock = std::function<double()>;

inline double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct MeasureOptions {
  int repeats = 7;
  int fewest_repeats = 3;
  double budget = 1.0;  ///< seconds for one bench, both sides together; fewer repeats if it would take longer
  double shortest_sample = 0.005;  ///< seconds; shorter calls are repeated within one sample
};

/// Milliseconds of one call.
struct Timing {
  Quartiles ours;
  Quartiles yardstick;  ///< zero without a yardstick
  int repeats = 0;
};

namespace detail {

inline double seconds_of(const std::function<void()>& call, int calls, const Clock& clock) {
  const double start = clock();
  for (int i = 0; i < calls; ++i) call();
  return clock() - start;
}

/// How many calls fill a sample. The first call (cold caches, first use of memory) is not counted.
inline int calls_per_sample(const std::function<void()>& call, const MeasureOptions& options, const Clock& clock) {
  constexpr int most_calls = 100000;
  constexpr double surely_long = 4;  // even the cold call is this much longer than needed
  if (seconds_of(call, 1, clock) > surely_long * options.shortest_sample) return 1;
  int calls = 1;
  double taken = seconds_of(call, calls, clock);
  while (taken < options.shortest_sample && calls < most_calls) {
    calls = std::min(calls * 2, most_calls);
    taken = seconds_of(call, calls, clock);
  }
  return calls;
}

}  // namespace detail

/// Times `ours` and `yardstick` (which may be empty) in turn, so that both see the same state of the machine; who goes
/// first alternates. Both are warmed up before.
inline Timing measure(const std::function<void()>& ours, const std::function<void()>& yardstick,
                      const MeasureOptions& options, const Clock& clock = steady_seconds) {
  const bool both = static_cast<bool>(yardstick);
  const int our_calls = detail::calls_per_sample(ours, options, clock);
  const int yardstick_calls = both ? detail::calls_per_sample(yardstick, options, clock) : 0;
  std::vector<double> our_samples, yardstick_samples;
  const auto sample_ours = [&] { our_samples.push_back(1e3 * detail::seconds_of(ours, our_calls, clock) / our_calls); };
  const auto sample_yardstick = [&] {
    yardstick_samples.push_back(1e3 * detail::seconds_of(yardstick, yardstick_calls, clock) / yardstick_calls);
  };

  const double start = clock();
  int round = 0;
  for (; round < options.repeats; ++round) {
    if (round >= options.fewest_repeats && clock() - start > options.budget) break;
    if (round % 2 == 0) {
      sample_ours();
      if (both) sample_yardstick();
    } else {
      if (both) sample_yardstick();
      sample_ours();
    }
  }
  return {quartiles(our_samples), both ? quartiles(yardstick_samples) : Quartiles{}, round};
}

}  // namespace ps::bench
