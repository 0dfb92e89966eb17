#pragma once
#include <map>
#include <string>
#include <vector>

#include "study/stability/experiment.h"

namespace ps::test {

/// A measured curve of a stability experiment, found by series and knob. The seed is fixed and printed with every
/// failure: rates that are 0 within what the counts can tell stay 0.
class Curve {
 public:
  explicit Curve(std::string_view key, double effort = 0.1, std::uint32_t seed = 1);

  const StabilityRow& at(const std::string& series, double knob) const;
  double naive(const std::string& series, double knob) const { return at(series, knob).naive; }
  double robust(const std::string& series, double knob) const { return at(series, knob).robust; }
  std::uint32_t seed() const { return seed_; }
  bool empty() const { return rows_.empty(); }
  bool has(const std::string& series, double knob) const { return rows_.contains({series, knob}); }

  /// Rates may lie within a factor of 1.5 of the given figure; those given as 0 must be 0. `noise` is what three
  /// standard deviations of our own count allow besides.
  void expect_naive(const std::string& series, double knob, double given, double noise = 0) const;
  void expect_robust(const std::string& series, double knob, double given, double noise = 0) const;
  void expect_all_robust_zero() const;

 private:
  void expect(double value, double given, const std::string& series, double knob, double noise) const;
  std::string key_;
  std::uint32_t seed_;
  std::map<std::pair<std::string, double>, StabilityRow> rows_;
};

}  // namespace ps::test
