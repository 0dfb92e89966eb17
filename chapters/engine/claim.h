#pragma once
#include <string_view>

#include "base/progress.h"
#include "engine/lesson.h"

namespace ps {

/// "differing-pixels": the metric's name in a lesson file.
std::string_view metric_key(ClaimMetric metric);
/// Throws InputError, naming the metrics there are.
ClaimMetric parse_metric(std::string_view key);
/// ">=", "<=" or "="
std::string_view bound_text(ClaimBound bound);

/// Measures the claim's number on the pictures of `document`, which must be at the claim's state.
double measure(const Claim& claim, const Document& document, Progress& progress);

bool keeps_bound(const Claim& claim, double value);

/// What a check found.
struct ClaimResult {
  double value = 0;          ///< with the step's settings
  double mutated_value = 0;  ///< with the option of the mutation reset
  bool holds = false;        ///< the value keeps the bound
  bool has_teeth = false;    ///< the mutated value breaks it
  bool passed() const { return holds && has_teeth; }
};

/// Renders what the claim speaks of, with and without its mutation. Throws InputError when its scene cannot be loaded
/// and Cancelled.
ClaimResult check_claim(const Claim& claim, Progress& progress);

}  // namespace ps
