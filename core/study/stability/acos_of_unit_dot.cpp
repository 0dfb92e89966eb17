#include <algorithm>
#include <cmath>
#include <random>

#include "math/vec.h"
#include "study/stability/support.h"

namespace ps::stability::acos_of_unit_dot {

/// The angle of a normalised vector with itself: in float its square is above 1 for many vectors.
static std::vector<StabilityRow> measure_acos_of_unit_dot(const StabilityRun& run) {
  const int vectors = run.count(1000000);
  run.check();
  std::mt19937 random(run.seed);
  std::normal_distribution<float> gauss(0, 1);
  int naive = 0, robust = 0;
  for (int i = 0; i < vectors; ++i) {
    Vec3f v(gauss(random), gauss(random), gauss(random));
    v /= std::sqrt(dot(v, v));
    const float cosine = dot(v, v);
    naive += std::isnan(std::acos(cosine)) ? 1 : 0;
    robust += std::isnan(std::acos(std::clamp(cosine, -1.0f, 1.0f))) ? 1 : 0;
  }
  Rows rows(run);
  rows.push_back({1, "float unit vectors", percent(naive, vectors), percent(robust, vectors), "% NaN"});
  return rows;
}

static constexpr StabilitySeries acos_of_unit_dot_series[]{
    {.names = "*", .title = "unit vectors whose angle is not a number", .unit = "%"},
};

extern const StabilityExperiment acos_of_unit_dot{
    .key = "acos-of-unit-dot",
    .place = {Subject::numbers, 50},
    .title = "acos of a unit vector's square",
    .keywords = "NaN, arc cosine, domain, rounding, clamp",
    .knob = "length",
    .naive = "acos(dot)",
    .robust = "clamp to [-1, 1] first",
    .explanation =
        "Normalising rounds, so that many unit vectors are a little too long. acos of more than 1 is not a number.",
    .safe = "Nowhere in float.",
    .window = nowhere_safe,
    .series = acos_of_unit_dot_series,
    .measure = measure_acos_of_unit_dot};

}  // namespace ps::stability::acos_of_unit_dot
