#pragma once
#include <vector>

#include "study/chart.h"
#include "study/model/model_needs.h"

namespace ps {

/// The points of a chart from the full to the reduced model and settings, each a saving further than the one before.
/// Throws InputError where no part can go.
std::vector<SweepPoint> model_sweep(const ModelNeeds& needs, const Settings& base, const Settings& scene_start);
/// The question that the same asks for a chart.
ModelRequest model_request(const ChartRequest& chart);
/// The same for a chart's scene, view and settings, which are weighed first. Throws Cancelled, too.
std::vector<SweepPoint> model_sweep(const ChartRequest& chart, const Settings& scene_start, StudyControl& control);

}  // namespace ps
