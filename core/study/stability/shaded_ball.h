#pragma once
#include "scene/mesh.h"
#include "study/stability/support.h"

namespace ps::stability {

/// RMSE in levels of 255 of a ball of triangles against the smooth ball, over the pixels that show both and 20 lights.
struct ShadedBallErrors {
  double corners = 0;  ///< lit at the corners and mixed (Gouraud)
  double pixels = 0;   ///< lit at each pixel with the mixed normal, brought back to length 1 (Phong)
  double facets = 0;   ///< lit at the middle of each triangle with its own normal
};

/// The ball has radius 1 and is seen from far away along z; its rim, seen at less than 17 degrees, is left out. Light
/// as in CGFS ch. 3, white and clamped, one light at a time: at most 0.6 diffuse and 0.5 in a highlight of this
/// exponent.
ShadedBallErrors shaded_ball_errors(const Mesh& ball, double exponent, const StabilityRun& run);

/// The highlight at a normal: the mirrored light against the view, to a power (CGFS ch. 3).
double highlight(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_eye, double exponent);

}  // namespace ps::stability
