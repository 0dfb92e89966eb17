#pragma once
#include <string>

#include "engine/metric.h"

namespace ps {

/// The quantity that a metric measures, as a noun phrase: "pixels that differ", "shadow rays in A".
std::string metric_words(const Metric& metric);
/// "at least 1,000", "at most 3", "121", "0.333 ± 0.001"
std::string bound_words(const Bound& bound);
/// A value of the metric in words: "yes" or "no" for a winner, otherwise as measured_text() has it.
std::string value_words(const Metric& metric, double value);
/// What a bound demands of the metric, in the words of value_words() and bound_words().
std::string demand_words(const Metric& metric, const Bound& bound);
/// Whole numbers in full, with their thousands apart ("41,231"), others with four significant digits.
std::string measured_text(double value);

}  // namespace ps
