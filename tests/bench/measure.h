#pragma once
#include "study/timing.h"

namespace ps::bench {

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

/// Times `ours` and `yardstick` (which may be empty) in turn, so that both see the same state of the machine; who goes
/// first alternates. Both are warmed up before.
inline Timing measure(const std::function<void()>& ours, const std::function<void()>& yardstick,
                      const MeasureOptions& options, const Clock& clock = steady_seconds) {
  const bool both = static_cast<bool>(yardstick);
  const int our_calls = calls_per_sample(ours, options.shortest_sample, clock);
  const int yardstick_calls = both ? calls_per_sample(yardstick, options.shortest_sample, clock) : 0;
  std::vector<double> our_samples, yardstick_samples;
  const auto sample_ours = [&] { our_samples.push_back(sample_milliseconds(ours, our_calls, clock)); };
  const auto sample_yardstick = [&] {
    yardstick_samples.push_back(sample_milliseconds(yardstick, yardstick_calls, clock));
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
