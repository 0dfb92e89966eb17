#pragma once
#include <string>
#include <vector>

#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// What the chosen renderer cannot show of this scene, in whole sentences; empty if it shows everything.
std::vector<std::string> left_out(const Scene& scene, const Settings& settings);

}  // namespace ps
