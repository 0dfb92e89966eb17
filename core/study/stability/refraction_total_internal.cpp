#include <cmath>
#include <random>

#include "study/stability/support.h"

namespace ps::stability::refraction_total_internal {

/// Rays that leave glass, cosine-weighted over the hemisphere: Snell's law asks for the root of a negative number
/// beyond the critical angle. Robust: that branch is total reflection.
static void measure_refraction_total_internal(const StabilityRun& run, Rows& rows) {
  const int rays = run.count(1000000);
  for (const double index : {1.0, 1.1, 1.33, 1.5, 2.0, 2.4}) {
    run.check();
    std::mt19937 random(run.seed);
    std::uniform_real_distribution<double> unit(0, 1);
    int naive = 0, robust = 0;
    for (int i = 0; i < rays; ++i) {
      const double sine_squared = unit(random);  // cosine-weighted: sin^2 is uniform
      const double left = 1 - index * index * sine_squared;
      naive += std::isnan(std::sqrt(left)) ? 1 : 0;
      const double cosine = left < 0 ? std::sqrt(1 - sine_squared) : std::sqrt(left);
      robust += std::isnan(cosine) ? 1 : 0;
    }
    rows.add(index, "leaving the glass", 100.0 * naive / rays, 100.0 * robust / rays, "% NaN");
  }
}

extern const StabilityExperiment refraction_total_internal{
    .key = "refraction-total-internal",
    .place = {Subject::numbers, 40},
    .set_up = SetUp::reproduction,
    .title = "Total internal reflection",
    .keywords = "glass, Snell, NaN, total reflection, critical angle",
    .knob = "index of refraction",
    .naive = "Snell's law alone",
    .robust = "reflect beyond the critical angle",
    .explanation = "Beyond the critical angle the sine of the refracted ray would "
                   "exceed 1. Its cosine is then the root of a negative number.",
    .safe = "Index 1.",
    .window = {1, 1},
    .series = {{.names = "*", .title = "refracted directions that are not numbers", .unit = "%"}},
    .add_rows = measure_refraction_total_internal};

}  // namespace ps::stability::refraction_total_internal
