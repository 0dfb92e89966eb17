#pragma once
#include "frame/view.h"
#include "inspect/space_model.h"

namespace ps {

/// From where the space view looks at the scene: angles in radians about the axes of the scene's own camera.
struct SpaceOrbit {
  Vec3d pivot{0, 0, 0};  ///< what is at the centre
  double yaw = 0;        ///< 0 = looking as the camera does, positive = turned to its right
  double pitch = 0;      ///< how far above it the viewer is
  double distance = 1;   ///< from the pivot, world units
  bool operator==(const SpaceOrbit&) const = default;
};

enum class SpacePreset {
  outside,  ///< from the right, above and a little behind
  front,    ///< as the camera looks
  side,     ///< from its right: the camera at the left, the scene at the right
  top       ///< from above, likewise
};

/// The height of the view at a distance of 1.
inline constexpr double space_view_height = 0.75;

/// The nearest orbit that shows all of `bounds` in a picture of this shape (width / height). `base` as for orbit_view.
SpaceOrbit preset_orbit(SpacePreset preset, const SpaceBounds& bounds, const Camera& base, double aspect);
/// The view of an orbit about the axes of `base`, which are brought to right angles and length 1 with their handedness.
View orbit_view(const SpaceOrbit& orbit, const Camera& base, int width, int height);
/// The view through the picture's own camera, with `margin` (1 = none) around its image.
View through_camera(const View& picture, const Settings& settings, double margin, int width, int height);

}  // namespace ps
