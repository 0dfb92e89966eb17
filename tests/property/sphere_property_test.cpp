// The two sphere tests in float against the quadratic formula in long double, from near to a million radii away.
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "raytrace/clear/sphere_robust.h"

namespace ps::sphere_property_test {
namespace {

struct Outcome {
  double wrong = 0;        ///< share of rays whose hit or miss differs from the truth
  double off_surface = 0;  ///< root mean square distance of hits from the sphere
};

using SphereMethod = SphereRoots<float> (*)(const Vec3f&, const Vec3f&, float, const TracedSphere<float>&);

/// Parallel rays in a square of side 2.4 around the unit sphere, along a generic axis, from `distance` away.
Outcome measure(SphereMethod method, double distance, unsigned seed) {
  constexpr int rays = 100000;
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const Vec3d axis = Vec3d(0.36, 0.48, 0.8);
  const Vec3d side = Vec3d(0.8, -0.6, 0);
  const Vec3d up = cross(axis, side);
  const TracedSphere<float> sphere{{0, 0, 0}, 1};
  int wrong = 0, hits = 0;
  double squares = 0;
  for (int i = 0; i < rays; ++i) {
    const Vec3f origin(axis * -distance + side * (2.4 * unit() - 1.2) + up * (2.4 * unit() - 1.2));
    const Vec3f direction(axis);
    using Wide = glm::vec<3, long double, glm::defaultp>;
    const Wide o(origin), d(direction);
    const long double a = d.x * d.x + d.y * d.y + d.z * d.z;
    const long double b = o.x * d.x + o.y * d.y + o.z * d.z;
    const long double c = o.x * o.x + o.y * o.y + o.z * o.z - 1;
    const bool truth = b * b - a * c >= 0;
    const auto roots = method(origin, direction, dot(direction, direction), sphere);
    const bool found = roots.discriminant >= 0;
    wrong += found != truth ? 1 : 0;
    if (!found) continue;
    const Vec3d point = Vec3d(origin) + Vec3d(direction) * static_cast<double>(roots.near);
    const double off = std::sqrt(dot(point, point)) - 1;
    squares += off * off;
    ++hits;
  }
  return {static_cast<double>(wrong) / rays, std::sqrt(squares / std::max(hits, 1))};
}

TEST(SphereProperty, RobustTestHoldsWhereTheTextbookFails) {
  constexpr unsigned seed = 3;
  RecordProperty("seed", seed);
  struct Row {
    double distance, robust_wrong, robust_off, textbook_wrong;  // the first two: at most; the last: at least
  };
  // Measured elsewhere: remainder form 0, 0, 0, .0025 %, .02 %, 1.0 %; textbook 0, .037, 2.5, 42.5, 47.7, 48.1 %.
  const Row rows[] = {{3, 0, 5e-7, 0},         {100, 5e-5, 6e-6, 1e-4}, {1000, 5e-5, 5e-5, 0.01},
                      {4100, 1e-4, 3e-4, 0.3}, {1e5, 2e-3, 6e-3, 0.4},  {1e6, 0.02, 0.05, 0.4}};
  for (const Row& row : rows) {
    const Outcome robust = measure(sphere_robust<float>, row.distance, seed);
    const Outcome textbook = measure(sphere_quadratic<float>, row.distance, seed);
    std::cout << "distance " << row.distance << ": robust " << 100 * robust.wrong << " % wrong, " << robust.off_surface
              << " off; textbook " << 100 * textbook.wrong << " %, " << textbook.off_surface << "\n";
    EXPECT_LE(robust.wrong, row.robust_wrong);
    EXPECT_LE(robust.off_surface, row.robust_off);
    EXPECT_GE(textbook.wrong, row.textbook_wrong);
  }
}

TEST(SphereProperty, ARayFromTheSurfaceNeverMeetsItsStart) {
  std::mt19937_64 random(4);
  const auto unit = [&] { return static_cast<float>(random() >> 40) * 0x1p-23f - 1; };
  int naive_hits = 0;
  for (int i = 0; i < 100000; ++i) {
    const TracedSphere<float> sphere{{0, -5001, 0}, 5000};
    const Vec3f normal = Vec3f(unit() * 0.01f, 1, unit() * 0.01f);
    const Vec3f n = normal / std::sqrt(dot(normal, normal));
    const Vec3f point = sphere.centre + n * sphere.radius;
    Vec3f direction{unit(), unit(), unit()};
    if (dot(direction, point - sphere.centre) < 0) direction = -direction;
    const float a = dot(direction, direction);
    EXPECT_FALSE(sphere_from_surface(point, direction, a, sphere).far > 0);
    const auto naive = sphere_quadratic(point, direction, a, sphere);
    naive_hits += naive.far > 0 || naive.near > 0 ? 1 : 0;
    const auto inwards = sphere_from_surface(point, -direction, a, sphere);
    if (dot(direction, point - sphere.centre) > 0) {
      EXPECT_GT(inwards.far, 0);
    }
  }
  EXPECT_GT(naive_hits, 1000);
}

}  // namespace
}  // namespace ps::sphere_property_test
