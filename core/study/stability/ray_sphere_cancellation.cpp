#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "raytrace/clear/sphere_quadratic.h"
#include "raytrace/clear/sphere_robust.h"
#include "study/stability/support.h"

namespace ps::stability::ray_sphere_cancellation {

namespace {

/// What one method gets wrong about the unit sphere.
struct Errors {
  int wrong = 0;           ///< rays that hit where they should miss, or miss where they should hit
  double off_squared = 0;  ///< of distances from the surface, summed
  double turned = 0;       ///< largest angle between the normal there and the true one, degrees
  int hits = 0;
  double off_surface() const { return hits > 0 ? std::sqrt(off_squared / hits) : 0; }
};

enum class Method { textbook, remainder, textbook_double };

/// The discriminant from the remainder vector, with roots from the textbook's formula.
SphereRoots<float> sphere_remainder(const Vec3f& origin, const Vec3f& direction, float a,
                                    const TracedSphere<float>& sphere) {
  const Vec3f from_centre = origin - sphere.centre;
  const float b = -dot(from_centre, direction);
  SphereRoots<float> roots;
  roots.discriminant = remainder_discriminant(from_centre, direction, b / a, sphere.radius);
  const float root = std::sqrt(a * roots.discriminant);
  roots.near = (b - root) / a;
  roots.far = (b + root) / a;
  return roots;
}

/// Parallel rays along a generic axis at a unit sphere, spread evenly over a square of side 2.4; the truth is the same
/// ray in double with the robust test. The products of the remainder form are rounded to some 2e-8 of the distance, so
/// a ray that passes the outline within that may be judged either way: at 1000 radii that is one of 200,000 rays, and
/// no test in float avoids it.
Errors draw_errors(Method method, double distance, std::uint32_t seed, const StabilityRun& run) {
  run.check();
  const Vec3d along = glm::normalize(Vec3d(0.3, -0.5, 0.81));
  const Vec3d side = glm::normalize(cross(along, Vec3d(0, 1, 0)));
  const Vec3d upward = cross(side, along);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1.2, 1.2);
  Errors errors;
  const int rays = run.count(200000);
  for (int i = 0; i < rays; ++i) {
    const Vec3d start = side * place(random) + upward * place(random) - along * distance;
    const Vec3f origin(start), direction(along);
    const TracedSphere<float> sphere{{0, 0, 0}, 1};
    const float a = dot(direction, direction);
    const bool single = method != Method::textbook_double;
    const Vec3d o = single ? Vec3d(origin) : start, d = single ? Vec3d(direction) : along;
    const TracedSphere<double> exact{{0, 0, 0}, 1};
    const SphereRoots<double> true_roots = sphere_robust<double>(o, d, dot(d, d), exact);
    const bool truth = true_roots.discriminant >= 0;
    double discriminant = 0, t = 0;
    const auto use = [&](const auto& roots) {
      discriminant = static_cast<double>(roots.discriminant);
      t = static_cast<double>(roots.near);
    };
    switch (method) {
    case Method::textbook:
      use(sphere_quadratic<float>(origin, direction, a, sphere));
      break;
    case Method::remainder:
      use(sphere_remainder(origin, direction, a, sphere));
      break;
    case Method::textbook_double:
      use(sphere_quadratic<double>(o, d, dot(d, d), exact));
      break;
    }
    const bool hit = discriminant >= 0;
    errors.wrong += hit != truth ? 1 : 0;
    if (hit && truth) {
      const Vec3d point = o + d * t;
      const double off = std::sqrt(dot(point, point)) - 1;
      errors.off_squared += off * off;
      const Vec3d normal = o + d * true_roots.near;
      const double angle = std::atan2(glm::length(cross(normal, point)), dot(normal, point));
      errors.turned = std::max(errors.turned, angle * 180 / pi);
      ++errors.hits;
    }
  }
  return errors;
}

/// All draws together, but for the normal: the largest angle of a draw is that of the one ray that came closest to the
/// outline and scatters by as much as 2 between draws, so it is the median of the draws.
Errors errors_of(Method method, double distance, int draws, const StabilityRun& run) {
  Errors all;
  std::vector<double> turned;
  for (int i = 0; i < draws; ++i) {
    const Errors draw = draw_errors(method, distance, run.seed + static_cast<std::uint32_t>(i), run);
    all.wrong += draw.wrong;
    all.off_squared += draw.off_squared;
    all.hits += draw.hits;
    turned.push_back(draw.turned);
  }
  const auto middle = turned.begin() + static_cast<std::ptrdiff_t>(turned.size() / 2);
  std::nth_element(turned.begin(), middle, turned.end());
  all.turned = *middle;
  return all;
}

/// Adds both methods to the rows; `about` is added to the names of the series.
void compare(Rows& rows, Method naive, std::optional<Method> robust, const std::string& about, int draws,
             const StabilityRun& run) {
  const double rays = static_cast<double>(draws) * run.count(200000);
  for (const double distance : {3.0, 100.0, 1000.0, 2000.0, 4100.0, 1e5, 1e6}) {
    const Errors a = errors_of(naive, distance, draws, run);
    double wrong = std::nan(""), off = std::nan(""), turned = std::nan("");
    if (robust) {
      const Errors b = errors_of(*robust, distance, draws, run);
      wrong = percent(b.wrong, rays);
      off = b.off_surface();
      turned = b.turned;
    }
    rows.add(distance, "hit or miss" + about, percent(a.wrong, rays), wrong, "% of rays wrong");
    rows.add(distance, "place" + about, a.off_surface(), off, "radii off the surface (rms)");
    rows.add(distance, "normal" + about, a.turned, turned, "degrees at most");
  }
}

void measure_ray_sphere_cancellation(const StabilityRun& run, Rows& rows) {
  compare(rows, Method::textbook, Method::remainder, "", run.count(9, 1), run);
  compare(rows, Method::textbook_double, {}, ", textbook in double", 1, run);
}

/// The ball is equally large in the picture at every distance: the projection plane is as far away as it is.
StabilityPicture picture_ray_sphere(double distance) {
  StabilityPicture picture;
  picture.scene = fmt::format("viewport_size = 1 x 1\nprojection_plane_d = {}\nbackground = black\n"
                              "sphere {{ center = (0, 0, {}) radius = 1 color = (255, 255, 255) }}\n"
                              "light {{ type = ambient intensity = 0.3 }}\n"
                              "light {{ type = directional intensity = 0.7 direction = (1, 2, -2) }}\n",
                              distance / 3, distance);
  picture.robust.shadows = Shadows::none;
  picture.robust.near = 0;
  picture.naive = picture.robust;
  picture.naive.sphere_test = SphereTest::quadratic;
  return picture;
}

}  // namespace

extern const StabilityExperiment ray_sphere_cancellation{
    .key = "ray-sphere-cancellation",
    .place = {Subject::rays, 50},
    .set_up = SetUp::reproduction,
    .title = "Cancellation: ray and sphere",
    .keywords = "quadratic formula, discriminant, loss of significance, catastrophic cancellation",
    .knob = "distance / radius",
    .naive = "discriminant b^2 - 4ac (sphere-test = quadratic)",
    .robust = "discriminant from the remainder vector",
    .explanation = "With D = distance / radius, the relative error of c grows with D^2 and reaches 1 at D = 4096 in "
                   "float. The remainder vector compares lengths of the size of the radius, so only the rounding of "
                   "its own products is left, which grows with D.",
    .safe = "Up to 100 radii.",
    .window = {nowhere, 100},
    .series = {{.names = "hit or miss|hit or miss*",
                .title = "rays with a wrong hit and rays with a wrong miss",
                .unit = "%"},
               {.names = "place*", .title = "distance of hit points from the sphere (RMS)", .unit = "radii"},
               {.names = "normal*", .title = "largest error of the normal", .unit = "degrees"}},
    .add_rows = measure_ray_sphere_cancellation,
    .picture = picture_ray_sphere,
    .frames = {10.0, 100.0, 1000.0, 2000.0, 4100.0}};

}  // namespace ps::stability::ray_sphere_cancellation
