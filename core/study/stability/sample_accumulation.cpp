#include <cmath>
#include <random>

#include "study/stability/support.h"

namespace ps::stability {

/// Sum of n random samples in [0, 1) by a running float sum, against the same with Kahan's correction; the truth is
/// summed in double.
static std::vector<StabilityRow> measure_sample_accumulation(const StabilityRun& run) {
  Rows rows(run);
  for (const int n : {1000, 100000, 10000000, 100000000}) {
    std::mt19937 random(run.seed);
    float plain = 0, corrected = 0, lost = 0;
    double truth = 0;
    for (int i = 0; i < n; ++i) {
      if (i % 1000000 == 0) run.check();
      const float sample = static_cast<float>(random() >> 8) * 0x1p-24f;
      truth += static_cast<double>(sample);
      plain += sample;
      const float better = sample - lost;
      const float next = corrected + better;
      lost = (next - corrected) - better;
      corrected = next;
    }
    const auto error = [&](float sum) { return std::abs(static_cast<double>(sum) - truth) / truth; };
    rows.push_back({static_cast<double>(n), "uniform samples", error(plain), error(corrected), "relative error"});
  }
  return rows;
}

const StabilityExperiment sample_accumulation{
    .key = "sample-accumulation",
    .title = "Sums of many samples",
    .knob = "samples",
    .naive = "float sum",
    .robust = "Kahan's sum",
    .explanation =
        "A float sum of size S adds multiples of its own spacing only. From 16,777,216 on it no longer counts by ones.",
    .safe = "Up to a million samples for 1e-5.",
    .window = {nowhere, 1e6},
    .measure = measure_sample_accumulation};

}  // namespace ps::stability
