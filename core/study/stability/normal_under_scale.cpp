#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "scene/world.h"
#include "study/stability/support.h"

namespace ps::stability {

/// Planes x + y/m = const for many slopes m, stretched by s along x: the angle between the transformed normal and the
/// normal of the transformed plane, whose direction in the plane is known.
static std::vector<StabilityRow> measure_normal_under_scale(const StabilityRun& run) {
  constexpr double degrees = 57.29577951308232;
  Rows rows(run);
  for (const double scale : {1.0, 1.5, 2.0, 5.0, 10.0, 100.0}) {
    run.check();
    Transform transform;
    transform.scale = {scale, 1, 1};
    const Mat3d model = normal_matrix(transform, NormalTransform::model);
    const Mat3d inverse = normal_matrix(transform, NormalTransform::inverse_transpose);
    double naive = 0, robust = 0;
    for (int i = 0; i <= 90000; ++i) {
      const double angle = i / 1000.0 / degrees;
      const Vec3d normal(std::cos(angle), std::sin(angle), 0);
      const Vec3d in_plane = to_world(transform, {-std::sin(angle), std::cos(angle), 0});
      const auto tilt = [&](const Mat3d& matrix) {
        const double sine = dot(normal_to_world(matrix, normal), in_plane) / glm::length(in_plane);
        return std::asin(std::clamp(std::abs(sine), 0.0, 1.0)) * degrees;
      };
      naive = std::max(naive, tilt(model));
      robust = std::max(robust, tilt(inverse));
    }
    rows.push_back({scale, "all slopes", naive, robust, "degrees"});
  }
  return rows;
}

const StabilityExperiment normal_under_scale{
    .key = "normal-under-scale",
    .title = "Normals under a scale",
    .knob = "scale along one axis",
    .naive = "transform like positions",
    .robust = "inverse transpose",
    .explanation = "A plane that is stretched tilts one way and its normal, stretched with it, the other. The inverse "
                   "transpose keeps normal and plane perpendicular.",
    .safe = "Uniform scales only.",
    .window = {1, 1},
    .measure = measure_normal_under_scale};

}  // namespace ps::stability
