#include <cmath>

#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// Linear light as an sRGB level (IEC 61966-2-1).
double level_of(double linear) {
  const double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return 255 * value;
}

}  // namespace

/// A pixel of which white covers a share and black the rest: the mean of stored levels against the level of the mean
/// light.
static std::vector<StabilityRow> measure_srgb_averaging(const StabilityRun& run) {
  run.check();
  Rows rows(run);
  for (const double percent : {1.0, 5.0, 10.0, 24.0, 25.0, 50.0, 75.0, 90.0, 99.0}) {
    const double right = level_of(percent / 100);
    const double mean_of_levels = 255 * percent / 100;
    rows.push_back({percent, "white over black", std::abs(mean_of_levels - right), 0, "levels of 255"});
  }
  return rows;
}

const StabilityExperiment srgb_averaging{
    .key = "srgb-averaging",
    .title = "Averages of stored levels",
    .knob = "share of white (%)",
    .naive = "mean of levels",
    .robust = "mean of light",
    .explanation = "Stored levels are not proportional to light. Their mean makes edges too dark.",
    .safe = "Nowhere between black and white.",
    .window = nowhere_safe,
    .measure = measure_srgb_averaging};

}  // namespace ps::stability
