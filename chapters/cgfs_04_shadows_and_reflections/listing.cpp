#include <array>
#include <limits>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_04_shadows_and_reflections {
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

struct Intersection {
  const BookSphere* sphere = nullptr;
  double t = infinity;
};

Intersection closest_intersection(const BookScene& scene,
                                  Vec3d origin, Vec3d direction,
                                  double t_min, double t_max) {
  Intersection closest;
  for (const BookSphere& sphere : scene.spheres) {
    PS_EACH("sphere", sphere.name);
    const Roots roots =
        intersect_ray_sphere(origin, direction, sphere);
    for (const double t : roots) {
      if (t < closest.t && t_min < t && t < t_max) {
        closest = {&sphere, t};
        PS_WATCH("closest t so far", t);
      }
    }
  }
  return closest;
}

Vec3d reflect_ray(Vec3d ray, Vec3d normal) {
  const Vec3d along = normal * (2 * dot(normal, ray));
  return along - ray;
}

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

    // A shadow: something lies between the point and the light. A
    // point light is at t = 1, a directional one nowhere.
    const double t_min = scene.settings.shadow_epsilon;
    const double t_max = near ? 1 : infinity;
    const Intersection blocker =
        closest_intersection(scene, point, to_light, t_min, t_max);
    PS_WATCH("blocked by",
             blocker.sphere ? blocker.sphere->name : "nothing");
    if (blocker.sphere) continue;

    const double n_dot_l = dot(normal, to_light);
    PS_WATCH("N . L", n_dot_l);
    if (n_dot_l > 0) {
      const double lengths = length(normal) * length(to_light);
      intensity += light.intensity * n_dot_l / lengths;
      PS_WATCH("with diffuse", intensity);
    }

    if (specular != -1) {
      const Vec3d reflected = reflect_ray(to_light, normal);
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
                Vec3d direction, double t_min, double t_max,
                int recursion_depth) {
  PS_EACH("remaining bounces", recursion_depth);
  PS_WATCH("direction", direction);
  const Intersection closest =
      closest_intersection(scene, origin, direction, t_min, t_max);
  if (!closest.sphere) return scene.background;
  PS_WATCH("closest sphere", closest.sphere->name);
  PS_WATCH("t", closest.t);

  // The colour that the sphere has by itself.
  const Vec3d point = origin + direction * closest.t;
  PS_WATCH("point", point);
  const Vec3d from_centre = point - closest.sphere->centre;
  const Vec3d normal = from_centre * (1 / length(from_centre));
  PS_WATCH("normal", normal);
  const double specular = closest.sphere->specular;
  const double intensity =
      compute_lighting(scene, point, normal, -direction, specular);
  PS_WATCH("intensity", intensity);
  const Vec3d local_colour = closest.sphere->colour * intensity;
  PS_WATCH("local colour", local_colour);

  // The colour that it mirrors.
  const double r = closest.sphere->reflective;
  PS_WATCH("r", r);
  if (recursion_depth <= 0 || r <= 0) return local_colour;
  const Vec3d mirrored = reflect_ray(-direction, normal);
  const double epsilon = scene.settings.reflection_epsilon;
  const int bounces = recursion_depth - 1;
  const Vec3d reflected_colour =
      trace_ray(scene, point, mirrored, epsilon, infinity, bounces);
  PS_WATCH("reflected colour", reflected_colour);
  const Vec3d mixed = local_colour * (1 - r) + reflected_colour * r;
  PS_WATCH("mixed", mixed);
  return mixed;
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const Vec3d origin = scene.camera.position;
  const int bounces = scene.settings.reflection_depth;
  for (int x = canvas.left(); x < canvas.right(); ++x) {
    for (int y = canvas.bottom(); y < canvas.top(); ++y) {
      PS_PIXEL(x, y);
      const Vec3d direction = canvas_to_viewport(scene, x, y);
      const Vec3d colour =
          trace_ray(scene, origin, direction, 1, infinity, bounces);
      PS_WATCH("colour", colour);
      canvas.put_pixel(x, y, colour);
    }
  }
}

}  // namespace
}  // namespace cgfs_04_shadows_and_reflections

namespace textbook {
extern const Listing cgfs_04_shadows_and_reflections;
const Listing cgfs_04_shadows_and_reflections{
    .label = "shadows and reflections",
    .source = "CGFS ch. 4",
    .shows = "Lit spheres that cast shadows and mirror each other.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {"reflection-depth", "shadow-epsilon",
              "reflection-epsilon"},
    .draws = {.spheres = true,
              .light = true,
              .shadows = true,
              .reflections = true},
    .suits = [](const SceneTraits& traits,
                const Settings&) { return traits.spheres ? 3 : 0; },
    .draw = ps::cgfs_04_shadows_and_reflections::draw,
};
}  // namespace textbook
}  // namespace ps
