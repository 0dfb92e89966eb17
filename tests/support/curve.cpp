#include "support/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/trials.h"

namespace ps::test {

Curve::Curve(std::string_view key, double effort, std::uint32_t seed) : key_(key), seed_(seed) {
  for (const StabilityRow& row : find_stability_experiment(key).measure({seed, nullptr, effort}))
    rows_[{row.series, row.knob}] = row;
}

const StabilityRow& Curve::at(const std::string& series, double knob) const {
  for (const auto& [place, row] : rows_)
    if (place.first == series && std::abs(place.second - knob) <= 1e-6 * std::abs(knob)) return row;
  ADD_FAILURE() << key_ << " has no series '" << series << "' at " << knob;
  static const StabilityRow none;
  return none;
}

void Curve::expect_naive(const std::string& series, double knob, double given, double noise) const {
  expect(at(series, knob).naive, given, series, knob, noise);
}
void Curve::expect_robust(const std::string& series, double knob, double given, double noise) const {
  expect(at(series, knob).robust, given, series, knob, noise);
}
void Curve::expect_all_robust_zero() const {
  for (const auto& [place, row] : rows_) {
    if (std::isnan(row.robust)) continue;
    EXPECT_EQ(row.robust, 0) << key_ << ", " << place.first << " at " << place.second << ", seed " << seed_;
  }
}

void Curve::expect(double value, double given, const std::string& series, double knob, double noise) const {
  SCOPED_TRACE(key_ + ", " + series + " at " + std::to_string(knob) + ", seed " + std::to_string(seed_));
  if (given == 0) {
    EXPECT_EQ(value, 0);
    return;
  }
  // Sanitized code is compiled otherwise and rounds otherwise where a result hangs on the last bit.
  constexpr double factor = trial_divisor > 1 ? 3 : 1.5;
  EXPECT_LE(value, given * factor + noise);
  EXPECT_GE(value, given / factor - noise);
}

}  // namespace ps::test
