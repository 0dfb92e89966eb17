#pragma once
#include "study/stability/experiment.h"

namespace ps::stability {

std::vector<StabilityRow> ground_sphere_acne(const StabilityRun& run);
std::vector<StabilityRow> reflection_self_hit(const StabilityRun& run);
std::vector<StabilityRow> ray_sphere_cancellation(const StabilityRun& run);
std::vector<StabilityRow> interpolate_drift(const StabilityRun& run);
std::vector<StabilityRow> inverse_depth(const StabilityRun& run);
std::vector<StabilityRow> normal_under_scale(const StabilityRun& run);
std::vector<StabilityRow> recursion_depth(const StabilityRun& run);
std::vector<StabilityRow> srgb_averaging(const StabilityRun& run);
std::vector<StabilityRow> sample_accumulation(const StabilityRun& run);
std::vector<StabilityRow> refraction_total_internal(const StabilityRun& run);
std::vector<StabilityRow> acos_of_unit_dot(const StabilityRun& run);

}  // namespace ps::stability
