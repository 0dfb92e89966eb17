#include <array>
#include <limits>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_02_basic_ray_tracing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Roots = std::array<double, 2>;

// The way from the camera through a pixel of the canvas.
Vec3d canvas_to_viewport(const BookScene& scene, int x, int y) {
  const Camera& camera = scene.camera;
  const double across = x * camera.viewport_width / scene.width;
  const double upwards = y * camera.viewport_height / scene.height;
  PS_WATCH("across, upwards", Vec2d(across, upwards));
  return camera.right * across + camera.up * upwards +
         camera.forward * camera.projection_plane_d;
}

// The two solutions of |origin + t direction - centre| = radius.
Roots intersect_ray_sphere(Vec3d origin, Vec3d direction,
                           const BookSphere& sphere) {
  const double r = sphere.radius;
  const Vec3d co = origin - sphere.centre;
  const double a = dot(direction, direction);
  const double b = 2 * dot(co, direction);
  const double c = dot(co, co) - r * r;
  PS_WATCH("a, b, c", Vec3d(a, b, c));
  const double discriminant = b * b - 4 * a * c;
  PS_WATCH("discriminant", discriminant);
  if (discriminant < 0) return {infinity, infinity};
  const double t1 = (-b + std::sqrt(discriminant)) / (2 * a);
  const double t2 = (-b - std::sqrt(discriminant)) / (2 * a);
  PS_WATCH("t1, t2", Vec2d(t1, t2));
  return {t1, t2};
}

// The colour of the nearest sphere between t_min and t_max.
Vec3d trace_ray(const BookScene& scene, Vec3d origin,
                Vec3d direction, double t_min, double t_max) {
  double closest_t = infinity;
  const BookSphere* closest_sphere = nullptr;
  for (const BookSphere& sphere : scene.spheres) {
    PS_EACH("sphere", sphere.name);
    const Roots roots =
        intersect_ray_sphere(origin, direction, sphere);
    for (const double t : roots) {
      if (t < closest_t && t_min < t && t < t_max) {
        closest_t = t;
        closest_sphere = &sphere;
        PS_WATCH("closest t so far", closest_t);
      }
    }
  }
  if (!closest_sphere) return scene.background;
  PS_WATCH("closest sphere", closest_sphere->name);
  return closest_sphere->colour;
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const Vec3d origin = scene.camera.position;
  for (int x = canvas.left(); x < canvas.right(); ++x) {
    for (int y = canvas.bottom(); y < canvas.top(); ++y) {
      PS_PIXEL(x, y);
      const Vec3d direction = canvas_to_viewport(scene, x, y);
      PS_WATCH("direction", direction);
      const Vec3d colour =
          trace_ray(scene, origin, direction, 1, infinity);
      PS_WATCH("colour", colour);
      canvas.put_pixel(x, y, colour);
    }
  }
}

}  // namespace
}  // namespace cgfs_02_basic_ray_tracing

namespace textbook {
extern const Listing cgfs_02_basic_ray_tracing;
const Listing cgfs_02_basic_ray_tracing{
    .label = "basic ray tracing",
    .source = "CGFS ch. 2",
    .shows = "Spheres in their plain colours, by one ray for each "
             "pixel.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {},
    .draws = {.spheres = true},
    .suits =
        [](const SceneTraits& traits, const Settings& settings) {
          if (!traits.spheres) return 0;
          return settings.lighting ? 1 : 5;
        },
    .draw = ps::cgfs_02_basic_ray_tracing::draw,
};
}  // namespace textbook
}  // namespace ps
