#include <bit>
#include <cmath>
#include <cstdint>

#include "raytrace/clear/self_hit.h"
#include "raytrace/clear/triangle_moeller_trumbore.h"
#include "study/stability/support.h"

namespace ps::stability::constant_normal_bump {
namespace {

struct Rates {
  double rays = 0, parameter = 0, epsilon = 0, weights = 0, bump = 0, integer = 0, bound_alone = 0, robust = 0;
  double integer_offset = 0, bound_offset = 0;  ///< lengths, summed
  double hits = 0;
  double along_off_plane = 0, weighed_off_plane = 0;  ///< distances of the points of hits, summed
};

/// The point moved along n by a whole number of representable values (Waechter and Binder, Ray Tracing Gems ch. 6): 256
/// times the normal's component on each axis, or a 65536th of that component where the coordinate is below 1/32.
Vec3f integer_offset(const Vec3f& point, const Vec3f& n) {
  Vec3f moved;
  for (int axis = 0; axis < 3; ++axis) {
    const float coordinate = point[axis];
    const auto steps = static_cast<std::int32_t>(256.0f * n[axis]);
    const auto bits = std::bit_cast<std::int32_t>(coordinate);
    moved[axis] = std::abs(coordinate) < 1.0f / 32 ? coordinate + n[axis] / 65536
                                                   : std::bit_cast<float>(bits + (coordinate < 0 ? -steps : steps));
  }
  return moved;
}

bool meets(const Vec3f& origin, const Vec3f& direction, const TracedTriangle<float>& triangle, float t_min) {
  const auto result = triangle_moeller_trumbore<float>(origin, direction, triangle, 0);
  return result.verdict == TriangleVerdict::inside && result.t > t_min;
}

double distance_of(const Vec3f& a, const Vec3f& b) {
  const Vec3d way = Vec3d(a) - Vec3d(b);
  return std::sqrt(dot(way, way));
}

/// How far a point lies from the triangle's plane.
double off_plane(const Vec3f& point, const TracedTriangle<float>& triangle) {
  const Vec3d corner(triangle.a), normal = cross(Vec3d(triangle.b) - corner, Vec3d(triangle.c) - corner);
  return std::abs(dot(Vec3d(point) - corner, normal)) / std::sqrt(dot(normal, normal));
}

/// One hit as both tests find it.
struct Met {
  TracedTriangle<float> triangle;
  Vec3f along_ray, weighed;     ///< where Moeller-Trumbore puts it, by o + t d and by its weights
  SurfacePoint<float> surface;  ///< where the watertight test puts it
  Vec3f facing;                 ///< the normal on the side that the eye ray came from
};

constexpr int rays_a_hit = 20;

/// Random triangles with sides of about 1, so far from the origin along no axis, seen from 6 away: calls visit(met,
/// away) for rays into the half-space that the eye ray came from, which leave each hit, after at_hit(met).
template <class Hit, class Away>
void for_each_ray(double distance, int triangles, const StabilityRun& run, Hit&& at_hit, Away&& visit) {
  run.check();
  Random random(run.seed);
  const TracedGeometry<float> geometry;
  const Settings settings;
  const Vec3d centre = Vec3d(0.6, 0.64, 0.48) * distance;
  for (int i = 0; i < triangles; ++i) {
    Met met;
    met.triangle = {Vec3f(centre + random.in_cube(1)), Vec3f(centre + random.in_cube(1)),
                    Vec3f(centre + random.in_cube(1))};
    const TracedTriangle<float>& triangle = met.triangle;
    double u = random.unit(), v = random.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3d target = Vec3d(triangle.a) + Vec3d(triangle.b - triangle.a) * u + Vec3d(triangle.c - triangle.a) * v;
    Ray<float> ray{Vec3f(target + random.direction() * 6.0), Vec3f(0), 0, 0, no_primitive};
    ray.direction = Vec3f(target) - ray.origin;
    const auto naive = triangle_moeller_trumbore<float>(ray.origin, ray.direction, triangle, 0);
    const auto hit = triangle_watertight<float>(ray.origin, Shear<float>(ray.direction), triangle, TriangleGuard::none);
    if (naive.verdict != TriangleVerdict::inside || hit.verdict != TriangleVerdict::inside) continue;
    put_triangle_surface<float>(ray, {0, hit.t, hit.weights}, geometry, {}, triangle, settings, met.surface);
    const Vec3f& n = met.surface.geometric_normal;
    met.facing = met.surface.back_face ? -n : n;
    met.along_ray = ray.origin + ray.direction * naive.t;
    met.weighed = blend(naive.weights, triangle.a, triangle.b, triangle.c);
    at_hit(met);
    for (int k = 0; k < rays_a_hit; ++k) {
      const Vec3f away(random.direction());
      visit(met, dot(away, met.facing) < 0 ? -away : away);
    }
  }
}

Rates rates_at(double distance, const StabilityRun& run) {
  Rates rates;
  const auto at_hit = [&](const Met& met) {
    ++rates.hits;
    rates.along_off_plane += off_plane(met.along_ray, met.triangle);
    rates.weighed_off_plane += off_plane(met.weighed, met.triangle);
  };
  for_each_ray(distance, run.count(40000, 4000), run, at_hit, [&](const Met& met, const Vec3f& away) {
    const TracedTriangle<float>& triangle = met.triangle;
    ++rates.rays;
    rates.parameter += meets(met.along_ray, away, triangle, 0) ? 1 : 0;
    rates.epsilon += meets(met.along_ray, away, triangle, 1e-4f) ? 1 : 0;
    rates.weights += meets(met.weighed, away, triangle, 0) ? 1 : 0;
    rates.bump += meets(met.weighed + met.facing * 1e-4f, away, triangle, 0) ? 1 : 0;
    const Vec3f lifted = integer_offset(met.weighed, met.facing);
    rates.integer += meets(lifted, away, triangle, 0) ? 1 : 0;
    rates.integer_offset += distance_of(lifted, met.weighed);
    const Vec3f origin = offset_from_triangle(met.surface, away);
    rates.bound_alone += meets(origin, away, triangle, 0) ? 1 : 0;
    rates.bound_offset += distance_of(origin, met.surface.point);
    const auto again = triangle_watertight<float>(origin, Shear<float>(away), triangle, TriangleGuard::rounding_of_t);
    rates.robust += again.verdict == TriangleVerdict::inside && again.t > 0 ? 1 : 0;
  });
  return rates;
}

/// The rays that the bound does not save from plain Moeller-Trumbore all leave a dozen of 40,000 hits, so measuring
/// their share takes ten times as many rays. Percent.
double bound_alone(double distance, const StabilityRun& run) {
  double rays = 0, met_again = 0;
  const auto nothing = [](const Met&) {};
  for_each_ray(distance, run.count(400000, 4000), run, nothing, [&](const Met& met, const Vec3f& away) {
    ++rays;
    met_again += meets(offset_from_triangle(met.surface, away), away, met.triangle, 0) ? 1 : 0;
  });
  return percent(met_again, rays);
}

void measure(const StabilityRun& run, Rows& rows) {
  for (const double distance : {0.0, 1e3, 1e4, 1e5}) {
    const Rates rates = rates_at(distance, run);
    const double robust = percent(rates.robust, rates.rays);
    const auto add = [&](const char* series, double self_hits) {
      rows.add(distance, series, percent(self_hits, rates.rays), robust, "% self-hits");
    };
    add("o + t d", rates.parameter);
    add("o + t d, t > 1e-4", rates.epsilon);
    add("from the weights", rates.weights);
    add("normal bump 1e-4", rates.bump);
    add("256 representable numbers along the normal", rates.integer);
    add("bound of the error, plain Moeller-Trumbore", rates.bound_alone);
    rows.add(distance, "mean offset, 256 numbers and bound", rates.integer_offset / rates.rays,
             rates.bound_offset / rates.rays, "length");
    rows.add(distance, "mean distance from the plane, o + t d and weights", rates.along_off_plane / rates.hits,
             rates.weighed_off_plane / rates.hits, "length");
    rows.add(distance, "distance to plane: (o + t d) / barycentric", rates.along_off_plane / rates.weighed_off_plane,
             std::nan(""), "times");
  }
  rows.add(0, "bound of the error, plain Moeller-Trumbore, 400,000 triangles", bound_alone(0, run), std::nan(""),
           "% self-hits");
}

}  // namespace

extern const StabilityExperiment constant_normal_bump{
    .key = "constant-normal-bump",
    .place = {Subject::rays, 80},
    .title = "A constant bump along the normal",
    .keywords = "acne, shadow acne, bias, epsilon, offset, self-intersection",
    .knob = "distance of the world from the origin",
    .naive = "start as found, or 0.0001 along the normal",
    .robust = "offset by the bound of the point's own error",
    .explanation = "Rounding puts a hit point on either side of its triangle. A constant bump lifts it if floats there "
                   "are spaced more closely than the bump.",
    .safe = "A bump of 0.0001 up to a few hundred units from the origin.",
    .window = {nowhere, 100},
    .series = {{.names = "normal bump 1e-4|*", .title = "rays that hit the surface they leave", .unit = "%"},
               {.names = "mean offset*",
                .title = "mean length of the offset",
                .unit = "world units",
                .naive = "256 numbers along the normal",
                .robust = "bound of the error"},
               {.names = "mean distance*",
                .title = "mean distance of hit points from the plane",
                .unit = "world units",
                .naive = "o + t d",
                .robust = "from the barycentric weights"},
               {.names = "distance to plane*",
                .title = "distance from the plane, o + t d divided by barycentric",
                .unit = "times",
                .better = Better::neither,
                .naive = "ratio",
                .robust = "none"}},
    .add_rows = measure};

}  // namespace ps::stability::constant_normal_bump
