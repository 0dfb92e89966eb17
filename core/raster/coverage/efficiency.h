#pragma once
#include <optional>

#include "base/counters.h"

namespace ps::raster {

/// Covered samples for each test, a test being of a sample, a row, a cell or a piece of a triangle (CGPP 15.6.2 calls
/// it sample test efficiency). Nothing if nothing was tested.
inline std::optional<double> sample_test_efficiency(const Counters& counters) {
  const std::uint64_t tests = counters[Counter::coverage_tests] + counters[Counter::coverage_regions];
  if (tests == 0) return {};
  return static_cast<double>(counters[Counter::fragments]) / static_cast<double>(tests);
}

}  // namespace ps::raster
