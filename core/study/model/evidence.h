#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "raytrace/touched.h"
#include "study/control.h"

namespace ps::model {

/// The parts of a scene that its pictures show, as their kernels report them.
struct Evidence {
  Touched touched;  ///< by rays, and by the fragments that are in front
  /// For each texture, the finest level of detail that a fragment of a surface's colour reads; absent if none does.
  std::vector<std::optional<float>> finest_level;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;  ///< visible depth, along the camera's axis
  double pixels = 0;                                                       ///< of all views together
};

/// The evidence of all views, with the settings for rays, and for fragments with mipmaps. Throws Cancelled.
Evidence gather_evidence(const Scene& scene, const std::vector<View>& views, const Settings& rays, Settings fragments,
                         StudyControl& control, WorkerPriority priority);

}  // namespace ps::model
