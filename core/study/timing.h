#pragma once
#include <algorithm>
#include <chrono>
#include <functional>

#include "base/statistics.h"

namespace ps {

/// Seconds since some fixed moment. Tests pass a clock of their own.
using Clock = std::function<double()>;

inline double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Times whose medians are nearer to each other than this have no order that would be worth a sentence.
inline constexpr double least_time_ratio = 1.1;

/// Are two times equal, as far as their runs show? Their quartiles touch, or the medians are nearer to each other than
/// least_time_ratio. The one rule by which charts, timings and needs order times.
inline bool within_noise(const Quartiles& a, const Quartiles& b) {
  const bool touch = a.q1 <= b.q3 && b.q1 <= a.q3;
  return touch || std::max(a.median, b.median) < least_time_ratio * std::min(a.median, b.median);
}

/// Seconds that `calls` calls take.
inline double seconds_of(const std::function<void()>& call, int calls, const Clock& clock) {
  const double start = clock();
  for (int i = 0; i < calls; ++i) call();
  return clock() - start;
}

/// One sample of a timing: milliseconds of one call, as the mean of `calls` calls.
inline double sample_milliseconds(const std::function<void()>& call, int calls, const Clock& clock) {
  return 1e3 * seconds_of(call, calls, clock) / calls;
}

/// How many calls fill a sample of at least `shortest_sample` seconds. The first call (cold caches, first use of
/// memory) is not counted.
inline int calls_per_sample(const std::function<void()>& call, double shortest_sample, const Clock& clock) {
  constexpr int most_calls = 100000;
  constexpr double surely_long = 4;  // even the cold call is this much longer than needed
  if (seconds_of(call, 1, clock) > surely_long * shortest_sample) return 1;
  int calls = 1;
  double taken = seconds_of(call, calls, clock);
  while (taken < shortest_sample && calls < most_calls) {
    calls = std::min(calls * 2, most_calls);
    taken = seconds_of(call, calls, clock);
  }
  return calls;
}

}  // namespace ps
