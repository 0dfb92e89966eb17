#pragma once
#include <string>

#include "study/stability/support.h"

namespace ps::stability {

/// A floor at y = -1, in the light of a sun right above it, and a roof of 4 x 4 x 0.2 whose centre is 3 above the
/// origin: a scene's text. The camera is the book's, on the z axis.
std::string roof_text(double camera_z);

/// Settings that show shadows and nothing else worth noting; rays in double.
Settings shadow_settings(Renderer renderer, Shadows shadows, double near);

/// Of the scene's floor (object 0) that rays and fragments both show in 150 x 100 pixels, the percentage whose sun
/// (light 1) is seen in one only. Pixels beside another object or beside an edge of the shadow are left out, since
/// fragments round edges. Rays look for shadows with `near` as fragments do.
double wrong_floor_share(const Scene& scene, const Settings& fragments, const StabilityRun& run);

}  // namespace ps::stability
