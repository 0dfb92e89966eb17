#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "raytrace/sphere_robust.h"
#include "study/stability/experiments.h"

namespace ps::stability {

/// Parallel rays along a generic axis at a unit sphere, spread evenly over a square of side 2.4; the truth is the same
/// ray in double with the robust test.
std::vector<StabilityRow> ray_sphere_cancellation(const StabilityRun& run) {
  constexpr int rays = 200000;
  const Vec3d along = glm::normalize(Vec3d(0.3, -0.5, 0.81));
  const Vec3d side = glm::normalize(cross(along, Vec3d(0, 1, 0)));
  const Vec3d upward = cross(side, along);
  std::vector<StabilityRow> rows;
  for (const double distance : {3.0, 100.0, 1000.0, 2000.0, 4100.0, 1e5, 1e6}) {
    run.check();
    std::mt19937 random(run.seed);
    std::uniform_real_distribution<double> place(-1.2, 1.2);
    int naive_wrong = 0, robust_wrong = 0;
    for (int i = 0; i < rays; ++i) {
      const Vec3f origin(side * place(random) + upward * place(random) - along * distance);
      const Vec3f direction(along);
      const TracedSphere<float> sphere{{0, 0, 0}, 1};
      const float a = dot(direction, direction);
      const Vec3d exact_origin(origin), exact_direction(direction);
      const bool truth =
          sphere_robust<double>(exact_origin, exact_direction, dot(exact_direction, exact_direction), {{0, 0, 0}, 1})
              .discriminant >= 0;
      naive_wrong += (sphere_quadratic<float>(origin, direction, a, sphere).discriminant >= 0) != truth ? 1 : 0;
      robust_wrong += (sphere_robust<float>(origin, direction, a, sphere).discriminant >= 0) != truth ? 1 : 0;
    }
    rows.push_back({distance, "float", 100.0 * naive_wrong / rays, 100.0 * robust_wrong / rays,
                    "% of rays with a wrong hit or miss"});
  }
  return rows;
}

}  // namespace ps::stability
