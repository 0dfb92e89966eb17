#include <limits>
#include <numbers>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_05_camera {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The camera's own directions, in the world.
struct Axes {
  Vec3d right, up, forward;
};

Vec3d unit(const Vec3d& v) {
  const double size = length(v);
  return v / size;
}

// Forward is the way to the target, right is level, and up is
// perpendicular to both.
Axes look_at(Vec3d position, Vec3d target) {
  const Vec3d straight_up(0, 1, 0);
  const Vec3d forward = unit(target - position);
  PS_WATCH("forward", forward);
  const Vec3d right = unit(cross(straight_up, forward));
  PS_WATCH("right", right);
  const Vec3d up = cross(forward, right);
  PS_WATCH("up", up);
  return {right, up, forward};
}

// The side of a pixel on a viewport at distance 1. The angle is
// that between the viewport's upper and lower border.
double pixel_side(double degrees, int height) {
  PS_WATCH("field of view", degrees);
  const double half_angle = degrees / 2 * std::numbers::pi / 180;
  PS_WATCH("half angle", half_angle);
  const double half_height = portable::tan(half_angle);
  PS_WATCH("half height", half_height);
  return 2 * half_height / height;
}

// The way from the camera through a pixel of the canvas.
Vec3d through_pixel(const Axes& axes, double side, int x, int y) {
  const double across = x * side;
  const double upwards = y * side;
  PS_WATCH("across, upwards", Vec2d(across, upwards));
  return axes.right * across + axes.up * upwards + axes.forward;
}

// As in chapter 2: where the ray meets the sphere beyond t = 1.
double intersect_ray_sphere(Vec3d origin, Vec3d direction,
                            const BookSphere& sphere) {
  const double r = sphere.radius;
  const Vec3d co = origin - sphere.centre;
  const double a = dot(direction, direction);
  const double b = 2 * dot(co, direction);
  const double c = dot(co, co) - r * r;
  const double discriminant = b * b - 4 * a * c;
  PS_WATCH("discriminant", discriminant);
  if (discriminant < 0) return infinity;
  const double t1 = (-b + std::sqrt(discriminant)) / (2 * a);
  const double t2 = (-b - std::sqrt(discriminant)) / (2 * a);
  PS_WATCH("t1, t2", Vec2d(t1, t2));
  if (t2 > 1) return t2;
  return t1 > 1 ? t1 : infinity;
}

Vec3d trace_ray(const BookScene& scene, Vec3d origin,
                Vec3d direction) {
  double closest_t = infinity;
  Vec3d colour = scene.background;
  for (const BookSphere& sphere : scene.spheres) {
    PS_EACH("sphere", sphere.name);
    const double t =
        intersect_ray_sphere(origin, direction, sphere);
    if (t >= closest_t) continue;
    closest_t = t;
    colour = sphere.colour;
    PS_WATCH("closest t so far", closest_t);
  }
  return colour;
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const BookView view = book_view(scene.camera);
  const Axes axes = look_at(view.position, view.target);
  const double side = pixel_side(view.degrees, scene.height);
  for (int x = canvas.left(); x < canvas.right(); ++x) {
    for (int y = canvas.bottom(); y < canvas.top(); ++y) {
      PS_PIXEL(x, y);
      const Vec3d direction = through_pixel(axes, side, x, y);
      PS_WATCH("direction", direction);
      const Vec3d colour =
          trace_ray(scene, view.position, direction);
      PS_WATCH("colour", colour);
      canvas.put_pixel(x, y, colour);
    }
  }
}

}  // namespace
}  // namespace cgfs_05_camera

namespace textbook {
extern const Listing cgfs_05_camera;
const Listing cgfs_05_camera{
    .label = "camera",
    .source = "CGFS ch. 5",
    .shows = "Spheres in their plain colours, from a camera that "
             "looks at a point.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {},
    .draws = {.spheres = true},
    .suits = [](const SceneTraits& traits,
                const Settings&) { return traits.spheres ? 1 : 0; },
    .draw = ps::cgfs_05_camera::draw,
};
}  // namespace textbook
}  // namespace ps
