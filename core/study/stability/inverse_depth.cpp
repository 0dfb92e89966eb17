#include <algorithm>
#include <cmath>

#include "study/stability/support.h"

namespace ps::stability {

/// An edge from depth 1 to depth r, looked at along its whole length on the screen: z mixed as it is against 1/z mixed.
static std::vector<StabilityRow> measure_inverse_depth(const StabilityRun& run) {
  constexpr int places = 100000;
  Rows rows(run);
  for (const double ratio : {1.1, 2.0, 5.0, 10.0, 100.0, 1000.0}) {
    run.check();
    double naive = 0, robust = 0;
    for (int i = 0; i <= places; ++i) {
      const double s = static_cast<double>(i) / places;  // share of the way on the screen
      // The point of the edge seen there: depth d with (d - 1) / (ratio - 1) * ratio / d = s.
      const double truth = ratio / (ratio - s * (ratio - 1));
      const double z = 1 + s * (ratio - 1);
      const double from_inverse = 1 / (1 + s * (1 / ratio - 1));
      naive = std::max(naive, std::abs(z - truth) / (ratio - 1));
      robust = std::max(robust, std::abs(from_inverse - truth) / (ratio - 1));
    }
    rows.push_back({ratio, "largest on the edge", naive, robust, "share of the depth range"});
  }
  return rows;
}

const StabilityExperiment inverse_depth{
    .key = "z-vs-1-z",
    .title = "z against 1/z",
    .knob = "ratio of the depths of the ends",
    .naive = "mix z",
    .robust = "mix 1/z",
    .explanation = "Equal steps on the screen are not equal steps in depth. 1/z is linear on the screen, z is not.",
    .safe = "Ratios up to 1.1 for an error of 2.5 %.",
    .window = {nowhere, 1.1},
    .measure = measure_inverse_depth};

}  // namespace ps::stability
