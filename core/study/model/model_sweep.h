#pragma once
#include <vector>

#include "study/model/model_needs.h"
#include "study/sweep.h"

namespace ps {

inline constexpr std::string_view model_sweep_key = "needs";

/// The points of a chart from the full to the reduced model and settings, each a saving further than the one before.
/// Throws InputError where no part can go.
std::vector<SweepPoint> model_sweep(const ModelNeeds& needs, const Settings& base, const Settings& scene_start);

}  // namespace ps
