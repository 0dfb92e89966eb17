#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"

namespace ps {

/// One measured place of a curve. A method that does not exist in a series is NaN.
struct StabilityRow {
  double knob = 0;
  std::string series;
  double naive = std::numeric_limits<double>::quiet_NaN();
  double robust = std::numeric_limits<double>::quiet_NaN();
  std::string unit;
};

/// What an experiment may use: random numbers come from the seed alone, so a run can be repeated.
struct StabilityRun {
  std::uint32_t seed = 1;
  Progress* progress = nullptr;  ///< asked between knobs; may stop the experiment with Cancelled
  void check() const {
    if (progress) progress->check();
  }
};

/// A place where a method fails, with what does not fail there.
struct StabilityExperiment {
  std::string_view key;  ///< "ground-sphere-acne"
  std::string_view title;
  std::string_view knob;           ///< what is turned, with its unit
  std::string_view naive, robust;  ///< the two methods
  std::string_view explanation;    ///< why, in two sentences
  std::string_view safe;           ///< where the naive method may be used
  std::vector<StabilityRow> (*measure)(const StabilityRun&) = nullptr;
};

/// All experiments. Adding one is a file with its function, a line in experiments.h and a row in table.cpp.
std::span<const StabilityExperiment> stability_experiments();
/// Throws InputError naming the experiments that exist.
const StabilityExperiment& find_stability_experiment(std::string_view key);

/// The table "knob,series,naive,robust,unit"; a method that does not exist is an empty field.
std::string stability_csv(std::span<const StabilityRow> rows);

}  // namespace ps
