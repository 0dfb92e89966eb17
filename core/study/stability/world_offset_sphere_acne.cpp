#include <array>

#include <fmt/format.h>

#include "raytrace/sphere_quadratic.h"
#include "raytrace/sphere_robust.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// Does the float ray from `origin` meet the sphere beyond `epsilon`?
bool meets(const SphereRoots<float>& roots, float epsilon) {
  return roots.discriminant >= 0 && (roots.near > epsilon || roots.far > epsilon);
}

/// Points of a unit sphere at a distance from the origin, as float rays find them; those whose normal faces the light
/// are lit, whatever their shadow ray says.
std::vector<StabilityRow> measure(const StabilityRun& run) {
  const Vec3f to_light(Vec3d(0.6, 0.64, -0.48));
  std::vector<StabilityRow> rows;
  for (const double distance : {0.0, 10.0, 1e3, 1e4, 1e5, 1e6}) {
    run.check();
    Random random(run.seed);
    const TracedSphere<float> sphere{Vec3f(Vec3d(distance, 0, 0)), 1};
    std::array<double, 2> naive{};
    double lit = 0, robust = 0;
    const std::array epsilon{1e-3f, 1e-2f};
    const int rays = run.count(400000);
    for (int i = 0; i < rays; ++i) {
      const Vec3f eye(Vec3d(sphere.centre) + Vec3d(0, 0, -3));
      const Vec3f direction(Vec3d(random.between(-0.4, 0.4), random.between(-0.4, 0.4), 1));
      const auto roots = sphere_quadratic<float>(eye, direction, dot(direction, direction), sphere);
      if (!(roots.discriminant >= 0) || !(roots.near > 0)) continue;
      const Vec3f point = eye + direction * roots.near;
      const Vec3f out = point - sphere.centre;
      if (!(dot(out, to_light) > 0.02f)) continue;
      ++lit;
      const float a = dot(to_light, to_light);
      const auto shadow = sphere_quadratic<float>(point, to_light, a, sphere);
      for (std::size_t k = 0; k < 2; ++k) naive[k] += meets(shadow, epsilon[k]) ? 1 : 0;
      robust += meets(sphere_from_surface<float>(point, to_light, a, sphere), 0) ? 1 : 0;
    }
    for (std::size_t k = 0; k < 2; ++k)
      rows.push_back({distance, fmt::format("epsilon {}", epsilon[k]), percent(naive[k], lit), percent(robust, lit),
                      "% of lit points in their own shadow"});
  }
  return rows;
}

StabilityPicture picture(double distance) {
  StabilityPicture picture;
  const double x = distance, y = 0, z = 0;
  picture.scene = fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\ncamera {{ position = ({}, {}, {}) }}\n"
                              "sphere {{ center = ({}, {}, {}) radius = 1 color = (220, 180, 60) }}\n"
                              "light {{ type = ambient intensity = 0.2 }}\n"
                              "light {{ type = directional intensity = 0.8 direction = (0.6, 0.64, -0.48) }}\n",
                              x, y, z - 3, x, y, z);
  picture.naive.self_hit = SelfHit::epsilon;
  picture.naive.sphere_test = SphereTest::quadratic;
  return picture;
}

constexpr std::array frames{0.0, 1e3, 1e4, 1e5, 1e6};

}  // namespace

const StabilityExperiment world_offset_sphere_acne{
    .key = "world-offset-sphere-acne",
    .title = "Acne far from the origin",
    .knob = "distance of the world from the origin",
    .naive = "ignore hits up to epsilon",
    .robust = "the root that is 0 is left out",
    .explanation = "A point far from the origin is rounded to a coarser grid, so it lies farther off its surface. An "
                   "epsilon that served near the origin is soon smaller than that.",
    .safe = "Up to 10 units for 0.001.",
    .window = {nowhere, 10},
    .measure = measure,
    .picture = picture,
    .frames = frames};

}  // namespace ps::stability
