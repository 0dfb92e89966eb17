#pragma once
#include "options/settings.h"

namespace ps {

/// Rays are traced in squares of this many pixels a side; what is remembered from ray to ray ends at their borders.
inline constexpr int traced_tile_size = 32;

/// How the eye rays of a picture are chosen (CGFS ch. 5).
enum class SamplingMode {
  one,          ///< each pixel one ray through its sample position
  many,         ///< each pixel several rays, or one somewhere else in it
  adaptive,     ///< one ray, and several where neighbours differ
  subsampling,  ///< every n-th pixel is searched for; between, objects are assumed to reach from one to the next
};

struct SamplingPlan {
  SamplingMode mode = SamplingMode::one;
  SamplePattern pattern = SamplePattern::grid;
  int samples = 1;
  int taken = 0;  ///< only the first n samples of a pixel; 0 = all
  double threshold = 0;
  int step = 1;  ///< of subsampling, in pixels
  int averaged() const { return taken > 0 ? taken : samples; }
};

inline SamplingPlan sampling_plan(const Settings& settings) {
  SamplingPlan plan{SamplingMode::one,           settings.sample_pattern, settings.samples_per_pixel, 0,
                    settings.adaptive_threshold, settings.subsampling};
  if (settings.samples_per_pixel > 1 && settings.adaptive_sampling)
    plan.mode = SamplingMode::adaptive;
  else if (settings.samples_per_pixel > 1 || settings.sample_pattern != SamplePattern::grid)
    plan.mode = SamplingMode::many;
  else if (settings.subsampling > 1)
    plan.mode = SamplingMode::subsampling;
  return plan;
}

}  // namespace ps
