#include "raster/setup/projection.h"

#include <cmath>

#include <glm/matrix.hpp>

#include "base/check.h"
#include "math/unit.h"

namespace ps::raster {

CameraSpace make_camera_space(const Camera& camera) {
  const Mat3d to_world(camera.right, camera.up, camera.forward);
  const double volume = dot(camera.right, cross(camera.up, camera.forward));
  const double edges = length_of(camera.right) * length_of(camera.up) * length_of(camera.forward);
  if (!(std::abs(volume) > 1e-12 * edges)) throw InputError("the camera's right, up and forward lie in one plane");
  return {glm::inverse(to_world), camera.position, volume > 0 ? 1.0 : -1.0};
}

}  // namespace ps::raster
