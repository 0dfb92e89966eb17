#pragma once
#include "scene/scene.h"

namespace ps {

/// The parts of a scene that float cannot hold even in its working space (scene/working_space.h), for its own camera.
struct FloatLimits {
  /// An object, or a triangle of a model, that the camera can see is so small for its distance from the space's origin,
  /// or the camera so near to an object for its own, that the rounding of their places is seen.
  bool detail = false;
  /// The points of large triangles near the camera are rounded so, which fragments interpolate between far vertices.
  bool places = false;
  /// A point light lies nearer to a surface than interpolated places are exact.
  bool light_at_surface = false;
};
FloatLimits float_limits(const Scene& scene);

}  // namespace ps
