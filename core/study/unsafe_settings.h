#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "render/render.h"

namespace ps {

/// An option whose value leaves the safe window of a stability experiment, with what that does to a scene.
struct UnsafeSetting {
  std::string_view experiment;  ///< key of the experiment that explains why: "reflection-self-hit"
  std::string_view option;      ///< key of the option
  std::string value;            ///< as it is
  std::string safe;             ///< assignments that make it safe: "self-hit=offset"
  double bad_percent = 0;       ///< of this scene's pixels that are wrong because of it
};

struct UnsafeOptions {
  int side = 160;           ///< the picture's longer side while it is measured, px
  bool only_known = false;  ///< returns which options leave their window, without rendering
  WorkerPriority priority = WorkerPriority::normal;
};

/// What the settings risk in this scene and view, the worst first; empty for settings in every safe window. A pixel is
/// bad if it differs by more than 8 levels from the same settings made safe and computed in double, and the safe ones
/// in the settings' own precision do not. Throws Cancelled.
std::vector<UnsafeSetting> unsafe_settings(const Scene& scene, const View& view, const Settings& settings,
                                           Progress& progress, const UnsafeOptions& options = {});

}  // namespace ps
