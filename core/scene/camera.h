#pragma once
#include "math/vec.h"

namespace ps {

/// A camera frame in world space with its viewport (CGFS ch. 2 and 5). The frame is used exactly as given: it is
/// neither normalised nor made orthogonal. Camera axes are right, up, forward; see math/conventions.h.
struct Camera {
  Vec3d position{0, 0, 0};
  Vec3d right{1, 0, 0};
  Vec3d up{0, 1, 0};
  Vec3d forward{0, 0, 1};
  double viewport_width = 1;      ///< world units
  double viewport_height = 1;     ///< world units
  double projection_plane_d = 1;  ///< distance from the position to the viewport, world units
  bool operator==(const Camera&) const = default;
};

}  // namespace ps
