// The ground covers spheres that are in front of it.
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

// Where on the viewport a place of the canvas lies, as seen from the camera.
Vec3d canvas_to_viewport(const BookScene& scene, int x, int y) {
  const double across = x * scene.camera.viewport_width / scene.width;
  const double upwards = y * scene.camera.viewport_height / scene.height;
  PS_WATCH("across, upwards", Vec2d(across, upwards));
  return scene.camera.right * across + scene.camera.up * upwards +
         scene.camera.forward * scene.camera.projection_plane_d;
}

// The two solutions of |origin + t direction - centre| = radius.
std::array<double, 2> intersect_ray_sphere(const Vec3d& origin, const Vec3d& direction, const BookSphere& sphere) {
  const Vec3d from_centre = origin - sphere.centre;
  const double a = dot(direction, direction);
  const double b = 2 * dot(from_centre, direction);
  const double c = dot(from_centre, from_centre) - sphere.radius * sphere.radius;
  PS_WATCH("a, b, c", Vec3d(a, b, c));
  const double discriminant = b * b - 4 * a * c;
  PS_WATCH("discriminant", discriminant);
  if (discriminant < 0) return {infinity, infinity};
  const double t1 = (-b + std::sqrt(discriminant)) / (2 * a);
  const double t2 = (-b - std::sqrt(discriminant)) / (2 * a);
  PS_WATCH("t1, t2", Vec2d(t1, t2));
  return {t1, t2};
}

// The colour of the nearest sphere along the ray, between t_min and t_max.
Vec3d trace_ray(const BookScene& scene, const Vec3d& origin, const Vec3d& direction, double t_min, double t_max) {
  double closest_t = infinity;
  const BookSphere* closest_sphere = nullptr;
  for (const BookSphere& sphere : scene.spheres) {
    PS_EACH("sphere", sphere.name);
    for (const double t : intersect_ray_sphere(origin, direction, sphere)) {
      if (t_min < t && t < t_max) {
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
  for (int x = canvas.left(); x < canvas.right(); ++x) {
    for (int y = canvas.bottom(); y < canvas.top(); ++y) {
      PS_PIXEL(x, y);
      const Vec3d direction = canvas_to_viewport(scene, x, y);
      PS_WATCH("direction", direction);
      const Vec3d colour = trace_ray(scene, scene.camera.position, direction, 1, infinity);
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
    .shows = "Spheres in their plain colours, by one ray for each pixel.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {},
    .draws = {.spheres = true},
    .suits = [](const SceneTraits& traits,
                const Settings& settings) { return !traits.spheres     ? 0
                                                   : settings.lighting ? 1
                                                                       : 5; },
    .draw = ps::cgfs_02_basic_ray_tracing::draw,
};
}  // namespace textbook
}  // namespace ps
