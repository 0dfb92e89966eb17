#include <cmath>

#include "study/stability/support.h"

namespace ps::stability {

/// The book's Interpolate (CGFS ch. 6) adds a slope again and again. A steep edge near canvas position 512, where
/// floats are 2^-14 px apart: its slope of 4.49 such steps is rounded down at every addition.
static std::vector<StabilityRow> measure_interpolate_drift(const StabilityRun& run) {
  constexpr double step = 4.49 * 0x1p-14;
  Rows rows(run);
  for (const int n : {100, 600, 1000, 10000, 100000, 1000000}) {
    run.check();
    const double truth = 512 + step * n;
    const float start = 512, end = static_cast<float>(truth);
    float added = start;
    for (int i = 0; i < n; ++i) added += static_cast<float>(step);
    const float share = static_cast<float>(n) / static_cast<float>(n);
    const float direct = start + (end - start) * share;
    rows.push_back({static_cast<double>(n), "float", std::abs(static_cast<double>(added) - truth),
                    std::abs(static_cast<double>(direct) - truth), "px at the end of the edge"});
  }
  return rows;
}

const StabilityExperiment interpolate_drift{.key = "interpolate-drift",
                                            .title = "Interpolate drifts",
                                            .knob = "steps",
                                            .naive = "d += slope",
                                            .robust = "each value from the ends",
                                            .explanation =
                                                "Every addition rounds, and a constant slope rounds the same way each "
                                                "time. A value computed from the ends has one rounding only.",
                                            .safe = "Up to about 10,000 steps for a third of a pixel.",
                                            .window = {nowhere, 10000},
                                            .measure = measure_interpolate_drift};

}  // namespace ps::stability
