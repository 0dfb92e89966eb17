#include <array>
#include <limits>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_03_light {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Roots = std::array<double, 2>;

Vec3d canvas_to_viewport(const BookScene& scene, int x, int y) {
  const Camera& camera = scene.camera;
  const double across = x * camera.viewport_width / scene.width;
  const double upwards = y * camera.viewport_height / scene.height;
  return camera.right * across + camera.up * upwards +
         camera.forward * camera.projection_plane_d;
}

Roots intersect_ray_sphere(Vec3d origin, Vec3d direction,
                           const BookSphere& sphere) {
  const double r = sphere.radius;
  const Vec3d co = origin - sphere.centre;
  const double a = dot(direction, direction);
  const double b = 2 * dot(co, direction);
  const double c = dot(co, co) - r * r;
  const double discriminant = b * b - 4 * a * c;
  PS_WATCH("discriminant", discriminant);
  if (discriminant < 0) return {infinity, infinity};
  const double t1 = (-b + std::sqrt(discriminant)) / (2 * a);
  const double t2 = (-b - std::sqrt(discriminant)) / (2 * a);
  PS_WATCH("t1, t2", Vec2d(t1, t2));
  return {t1, t2};
}

// How much light a point sends to the viewer: a sum over all
// lights.
double compute_lighting(const BookScene& scene, Vec3d point,
                        Vec3d normal, Vec3d view, double specular) {
  double intensity = 0;
  for (const Light& light : scene.lights) {
    PS_EACH("light", kind_name(light));
    if (light.kind == LightKind::ambient) {
      intensity += light.intensity;
      PS_WATCH("intensity so far", intensity);
      continue;
    }
    const bool near = light.kind == LightKind::point;
    const Vec3d to_light =
        near ? light.position - point : light.direction;
    PS_WATCH("to light", to_light);

    // Diffuse: light that grazes the surface is spread thinly.
    const double n_dot_l = dot(normal, to_light);
    PS_WATCH("N . L", n_dot_l);
    if (n_dot_l > 0) {
      const double lengths = length(normal) * length(to_light);
      intensity += light.intensity * n_dot_l / lengths;
      PS_WATCH("with diffuse", intensity);
    }

    // Specular: how near the mirrored light comes to the viewer.
    if (specular != -1) {
      const Vec3d reflected = normal * (2 * n_dot_l) - to_light;
      const double r_dot_v = dot(reflected, view);
      PS_WATCH("R . V", r_dot_v);
      if (r_dot_v > 0) {
        const double lengths = length(reflected) * length(view);
        const double cosine = r_dot_v / lengths;
        intensity += light.intensity * power(cosine, specular);
        PS_WATCH("with specular", intensity);
      }
    }
  }
  return intensity;
}

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

  const Vec3d point = origin + direction * closest_t;
  PS_WATCH("point", point);
  const Vec3d from_centre = point - closest_sphere->centre;
  const Vec3d normal = from_centre * (1 / length(from_centre));
  PS_WATCH("normal", normal);
  const double specular = closest_sphere->specular;
  const double intensity =
      compute_lighting(scene, point, normal, -direction, specular);
  PS_WATCH("intensity", intensity);
  return closest_sphere->colour * intensity;
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
}  // namespace cgfs_03_light

namespace textbook {
extern const Listing cgfs_03_light;
const Listing cgfs_03_light{
    .label = "light",
    .source = "CGFS ch. 3",
    .shows =
        "Spheres with diffuse and specular light, without shadows.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {},
    .draws = {.spheres = true, .light = true},
    .suits =
        [](const SceneTraits& traits, const Settings& settings) {
          if (!traits.spheres) return 0;
          const bool shadows = settings.shadows != Shadows::none;
          if (!settings.lighting || shadows) return 2;
          return traits.reflective ? 2 : 5;
        },
    .draw = ps::cgfs_03_light::draw,
};
}  // namespace textbook
}  // namespace ps
