#include <algorithm>
#include <cmath>
#include <random>

#include "study/stability/support.h"

namespace ps::stability::sample_accumulation {

namespace {

/// A sum with the part that each addition lost, which the next one makes good.
class KahanSum {
 public:
  void add(float value) {
    const float better = value - lost_;
    const float next = sum_ + better;
    lost_ = (next - sum_) - better;
    sum_ = next;
  }
  float value() const { return sum_; }

 private:
  float sum_ = 0, lost_ = 0;
};

/// Relative errors against a sum in double.
struct Errors {
  double plain = 0, corrected = 0, running_mean = 0;
};

/// Samples in [0, 1) summed by a running float sum, by Kahan's, and as a mean that each sample moves by its share.
Errors add_uniform(int n, std::uint32_t seed, bool with_mean, const StabilityRun& run) {
  std::mt19937 random(seed);
  float plain = 0, mean = 0;
  KahanSum corrected;
  double truth = 0;
  for (int i = 0; i < n; ++i) {
    if (i % 1000000 == 0) run.check();
    const float sample = static_cast<float>(random() >> 8) * 0x1p-24f;
    truth += static_cast<double>(sample);
    plain += sample;
    corrected.add(sample);
    if (with_mean) mean += (sample - mean) / static_cast<float>(i + 1);
  }
  const auto error = [&](double sum) { return std::abs(sum - truth) / truth; };
  return {error(static_cast<double>(plain)), error(static_cast<double>(corrected.value())),
          error(static_cast<double>(mean) * n)};
}

std::vector<StabilityRow> measure_sample_accumulation(const StabilityRun& run) {
  Rows rows(run);
  constexpr int most = 100000000;
  for (const int n : {1000, 100000, 10000000, most}) {
    const Errors errors = add_uniform(n, run.seed, n == most, run);
    rows.push_back({static_cast<double>(n), "uniform samples", errors.plain, errors.corrected, "relative error"});
    if (n == most)
      rows.push_back(
          {most, "running mean of uniform samples", errors.running_mean, errors.corrected, "relative error"});
  }
  // Roundings up and down make a random walk of the error, so one draw says little about its size.
  constexpr std::uint32_t draws = 32;
  for (const int n : {1000, 100000, 1000000}) {
    double naive = 0, robust = 0;
    Errors largest;
    for (std::uint32_t i = 0; i < draws; ++i) {
      const Errors errors = add_uniform(n, run.seed + i, false, run);
      naive += errors.plain * errors.plain;
      robust += errors.corrected * errors.corrected;
      largest.plain = std::max(largest.plain, errors.plain);
      largest.corrected = std::max(largest.corrected, errors.corrected);
    }
    rows.push_back({static_cast<double>(n), "uniform samples, root mean square of 32 draws", std::sqrt(naive / draws),
                    std::sqrt(robust / draws), "relative error"});
    rows.push_back({static_cast<double>(n), "uniform samples, largest of 32 draws", largest.plain, largest.corrected,
                    "relative error"});
  }
  // Above 2^25 floats are 4 apart, so half of that, 4e-8 of this sum, is the most that Kahan's sum is off at its end;
  // where it ends between two of them is chance.
  double naive = 0, robust = 0;
  for (int i = 0; i < std::min(8, run.count(8)); ++i) {
    const Errors errors = add_uniform(most, run.seed + static_cast<std::uint32_t>(i), false, run);
    naive = std::max(naive, errors.plain);
    robust = std::max(robust, errors.corrected);
  }
  rows.push_back({most, "uniform samples, largest of 8 draws", naive, robust, "relative error"});
  float ones = 0;
  KahanSum corrected;
  for (int i = 0; i < most; ++i) {
    ones += 1;
    corrected.add(1);
  }
  rows.push_back({most, "sum of ones", static_cast<double>(ones), static_cast<double>(corrected.value()), "sum"});
  return rows;
}

}  // namespace

static constexpr StabilitySeries sample_accumulation_series[]{
    {.names = "uniform samples|*", .title = "error of the mean", .unit = "share of the mean"},
    {.names = "sum of ones", .title = "sum of 100,000,000 ones", .unit = "ones", .better = Better::higher},
};

extern const StabilityExperiment sample_accumulation{
    .key = "sample-accumulation",
    .place = {Subject::numbers, 20},
    .set_up = SetUp::reproduction,
    .title = "Summation error: float sums of many samples",
    .keywords = "accumulation buffer, float sum, Kahan, stagnation",
    .knob = "samples",
    .naive = "float sum",
    .robust = "Kahan's sum",
    .explanation =
        "A float sum of size S adds multiples of its own spacing only. From 16,777,216 on it no longer counts by ones.",
    .safe = "Up to a million samples for 1e-5.",
    .window = {nowhere, 1e6},
    .series = sample_accumulation_series,
    .measure = measure_sample_accumulation};

}  // namespace ps::stability::sample_accumulation
