#pragma once
#include <optional>

#include "base/counters.h"

namespace ps::raster {

/// Covered samples for each test, a test being of a sample, a row, a cell or a piece of a triangle (CGPP 15.6.2 calls
/// it sample test efficiency). nullopt if nothing was tested, or if the renderer does not count tests.
inline std::optional<double> sample_test_efficiency(const Counters& counters) {
  const auto samples = counters.get(Counter::coverage_tests), regions = counters.get(Counter::coverage_regions);
  const auto fragments = counters.get(Counter::fragments);
  if (!samples || !regions || !fragments || *samples + *regions == 0) return {};
  return static_cast<double>(*fragments) / static_cast<double>(*samples + *regions);
}

}  // namespace ps::raster
