// Sides that face away from a light are darker than ambient light leaves them.
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

Vec3d canvas_to_viewport(const BookScene& scene, int x, int y) {
  const double across = x * scene.camera.viewport_width / scene.width;
  const double upwards = y * scene.camera.viewport_height / scene.height;
  return scene.camera.right * across + scene.camera.up * upwards +
         scene.camera.forward * scene.camera.projection_plane_d;
}

std::array<double, 2> intersect_ray_sphere(const Vec3d& origin, const Vec3d& direction, const BookSphere& sphere) {
  const Vec3d from_centre = origin - sphere.centre;
  const double a = dot(direction, direction);
  const double b = 2 * dot(from_centre, direction);
  const double c = dot(from_centre, from_centre) - sphere.radius * sphere.radius;
  const double discriminant = b * b - 4 * a * c;
  PS_WATCH("discriminant", discriminant);
  if (discriminant < 0) return {infinity, infinity};
  const double t1 = (-b + std::sqrt(discriminant)) / (2 * a);
  const double t2 = (-b - std::sqrt(discriminant)) / (2 * a);
  PS_WATCH("t1, t2", Vec2d(t1, t2));
  return {t1, t2};
}

// How much light a point sends towards the viewer: the sum over all lights.
double compute_lighting(const BookScene& scene, const Vec3d& point, const Vec3d& normal, const Vec3d& view,
                        double specular) {
  double intensity = 0;
  for (const Light& light : scene.lights) {
    PS_EACH("light", kind_name(light));
    if (light.kind == LightKind::ambient) {
      intensity += light.intensity;
      PS_WATCH("intensity so far", intensity);
      continue;
    }
    const Vec3d to_light = light.kind == LightKind::point ? light.position - point : light.direction;
    PS_WATCH("to light", to_light);

    // Diffuse: the more the light grazes the surface, the thinner it is spread.
    const double n_dot_l = dot(normal, to_light);
    PS_WATCH("N . L", n_dot_l);
    if (length(to_light) > 0) {
      intensity += light.intensity * n_dot_l / (length(normal) * length(to_light));
      PS_WATCH("with diffuse", intensity);
    }

    // Specular: how near the mirrored light comes to the viewer.
    if (specular != -1) {
      const Vec3d reflected = normal * (2 * n_dot_l) - to_light;
      const double r_dot_v = dot(reflected, view);
      PS_WATCH("R . V", r_dot_v);
      if (r_dot_v > 0) {
        intensity += light.intensity * power(r_dot_v / (length(reflected) * length(view)), specular);
        PS_WATCH("with specular", intensity);
      }
    }
  }
  return intensity;
}

Vec3d trace_ray(const BookScene& scene, const Vec3d& origin, const Vec3d& direction, double t_min, double t_max) {
  double closest_t = infinity;
  const BookSphere* closest_sphere = nullptr;
  for (const BookSphere& sphere : scene.spheres) {
    PS_EACH("sphere", sphere.name);
    for (const double t : intersect_ray_sphere(origin, direction, sphere)) {
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
  const double intensity = compute_lighting(scene, point, normal, -direction, closest_sphere->specular);
  PS_WATCH("intensity", intensity);
  return closest_sphere->colour * intensity;
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
}  // namespace cgfs_03_light

namespace textbook {
extern const Listing cgfs_03_light;
const Listing cgfs_03_light{
    .label = "light",
    .source = "CGFS ch. 3",
    .shows = "Spheres with diffuse and specular light, without shadows.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {},
    .draws = {.spheres = true, .light = true},
    .suits =
        [](const SceneTraits& traits, const Settings& settings) {
          if (!traits.spheres) return 0;
          return settings.lighting && settings.shadows == Shadows::none && !traits.reflective ? 5 : 2;
        },
    .draw = ps::cgfs_03_light::draw,
};
}  // namespace textbook
}  // namespace ps
