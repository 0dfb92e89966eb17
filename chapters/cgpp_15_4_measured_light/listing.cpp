#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgpp_15_4_measured_light {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

struct Triangle {
  std::array<Vec3d, 3> vertices, normals;  // in the world
  Material material;
  Sides sides = Sides::two;
  std::string_view object;
  std::int64_t number = 0;
};

using Triangles = std::vector<Triangle>;

struct Ray {
  Vec3d origin, direction;
  double t_min = 0, t_max = infinity;
};

// The first triangle on a ray, if any.
struct Hit {
  const Triangle* triangle = nullptr;
  double t = infinity;
  Vec3d weights{0, 0, 0};
};

// Distance along the ray and three weights, by Cramer's rule;
// infinity for a ray that passes by, or that meets the back of a
// triangle with one side.
double intersect(const Ray& ray, const Triangle& triangle,
                 Vec3d& weights) {
  const auto& [v0, v1, v2] = triangle.vertices;
  const Vec3d e1 = v1 - v0, e2 = v2 - v0;
  const Vec3d q = cross(ray.direction, e2);
  const double a = dot(e1, q);
  PS_WATCH("a", a);  // above 0 in front of the triangle
  if (a == 0) return infinity;
  if (a < 0 && triangle.sides == Sides::front) return infinity;
  const Vec3d s = ray.origin - v0;
  const Vec3d r = cross(s, e1);
  const double w1 = dot(s, q) / a;
  const double w2 = dot(ray.direction, r) / a;
  weights = {1 - w1 - w2, w1, w2};
  PS_WATCH("weights", weights);
  if (w1 < 0 || w2 < 0 || w1 + w2 > 1) return infinity;
  const double t = dot(e2, r) / a;
  PS_WATCH("t", t);
  return t;
}

// The nearest triangle along the ray, between t_min and t_max.
Hit nearest(const Triangles& triangles, const Ray& ray) {
  Hit closest;
  closest.t = ray.t_max;
  for (const Triangle& triangle : triangles) {
    PS_EACH("triangle of", triangle.object);
    PS_WATCH("number", triangle.number);
    Vec3d weights(0);
    const double t = intersect(ray, triangle, weights);
    if (t <= ray.t_min || t >= closest.t) continue;
    closest = {&triangle, t, weights};
    PS_WATCH("closest t so far", t);
  }
  return closest;
}

// Which share of the light from one direction a surface scatters to
// another one: Lambert's law, and a highlight that is brighter the
// sharper it is. Lights may have another colour in highlights.
Vec3d scattered(const Material& material, const Light& light,
                Vec3d normal, Vec3d to_light, Vec3d to_eye) {
  const Vec3d matte = material.colour / pi * light.colour;
  if (!material.specular) return matte;
  const Vec3d l = to_light / length(to_light);
  const Vec3d v = to_eye / length(to_eye);
  const Vec3d half = l + v;
  const double lengths = length(normal) * length(half);
  const double cosine = dot(normal, half) / lengths;
  PS_WATCH("N . H", cosine);
  if (!(cosine > 0)) return matte;
  const double s = *material.specular;
  const double peak = (s + 8) / (8 * pi);
  const Vec3d tint =
      material.specular_colour.value_or(material.colour);
  const Vec3d share = tint * (peak * power(cosine, s));
  return matte + share * highlight_colour(light);
}

// The radiance towards the eye: what the lights send that reaches
// the point and is scattered there.
Vec3d shade(const BookScene& scene, const Triangles& triangles,
            Vec3d point, Vec3d normal, Vec3d to_eye,
            const Material& material) {
  const Vec3d ambient =
      material.ambient_colour.value_or(material.colour);
  Vec3d radiance(0);
  for (const Light& light : scene.lights) {
    PS_EACH("light", kind_name(light));
    if (light.kind == LightKind::ambient) {
      radiance += ambient * light.colour * light.intensity;
      continue;
    }
    const bool near = light.kind == LightKind::point;
    const Vec3d to_light =
        near ? light.position - point : light.direction;
    PS_WATCH("to light", to_light);
    // A point light spreads its power over a sphere.
    const double distance = length(to_light);
    const double sphere = 4 * pi * distance * distance;
    const double arriving =
        near ? light.intensity / sphere : light.intensity;
    radiance += ambient * light.ambient_colour * arriving;

    const double epsilon = scene.settings.shadow_epsilon;
    const double t_max = near ? 1 : infinity;
    const Ray to{point, to_light, epsilon, t_max};
    const Triangle* blocker = nearest(triangles, to).triangle;
    PS_WATCH("blocked by", blocker ? blocker->object : "nothing");
    if (blocker) continue;

    PS_WATCH("arriving", arriving);
    // A surface at an angle catches less of it.
    const double lengths = length(normal) * distance;
    const double cosine = dot(normal, to_light) / lengths;
    PS_WATCH("cosine", cosine);
    if (cosine <= 0) continue;
    const Vec3d share =
        scattered(material, light, normal, to_light, to_eye);
    radiance += share * (arriving * cosine);
    PS_WATCH("radiance so far", radiance);
  }
  return radiance;
}

Vec3d trace_ray(const BookScene& scene, const Triangles& triangles,
                const Ray& ray) {
  const Hit hit = nearest(triangles, ray);
  if (!hit.triangle) return scene.background;
  const auto& v = hit.triangle->vertices;
  const auto& n = hit.triangle->normals;
  const Vec3d w = hit.weights;
  const Vec3d point = v[0] * w.x + v[1] * w.y + v[2] * w.z;
  PS_WATCH("point", point);
  const Vec3d normal = n[0] * w.x + n[1] * w.y + n[2] * w.z;
  PS_WATCH("normal", normal);
  const Material& material = hit.triangle->material;
  PS_WATCH("surface colour", material.colour * 255.0);
  const Vec3d to_eye = -ray.direction;
  const Vec3d radiance =
      shade(scene, triangles, point, normal, to_eye, material);
  PS_WATCH("radiance", radiance);
  return radiance * 255.0;
}

Triangles triangles_of(const BookScene& scene) {
  const auto& materials = *scene.scene.materials;
  Triangles all;
  for (const BookInstance& instance : scene.instances) {
    const Mesh& model = *instance.model;
    const Instance& placed = *instance.instance;
    const Mat4d to_world = model_to_world(placed.transform);
    const Mat4d turned = rotation_matrix(placed.transform.rotation);
    for (const MeshTriangle& face : model.triangles) {
      const auto own = model.materials.at(face.material);
      Triangle made;
      made.material = materials.at(placed.material.value_or(own));
      made.sides = placed.sides;
      made.object = instance.name;
      made.number = instance.number_of(face);
      auto& v = made.vertices;
      for (std::size_t k = 0; k < 3; ++k)
        v[k] =
            transform(to_world, model.positions[face.position[k]]);
      const Vec3d flat = cross(v[1] - v[0], v[2] - v[0]);
      for (std::size_t k = 0; k < 3; ++k) {
        Vec3d normal = flat;
        const auto index = static_cast<std::size_t>(face.normal[k]);
        if (face.normal[k] >= 0)
          normal = turn(turned, model.normals[index]);
        made.normals[k] = normal / length(normal);
      }
      all.push_back(made);
    }
  }
  return all;
}

// From the eye through a place of the canvas.
Vec3d eye_direction(const BookScene& scene, int x, int y) {
  const Camera& camera = scene.camera;
  const double across = x * camera.viewport_width / scene.width;
  const double up = y * camera.viewport_height / scene.height;
  return camera.right * across + camera.up * up +
         camera.forward * camera.projection_plane_d;
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const Triangles triangles = triangles_of(scene);
  const Vec3d origin = scene.camera.position;
  const double near = scene.settings.near;
  for (int y = canvas.bottom(); y < canvas.top(); ++y) {
    for (int x = canvas.left(); x < canvas.right(); ++x) {
      PS_PIXEL(x, y);
      const Vec3d direction = eye_direction(scene, x, y);
      PS_WATCH("direction", direction);
      const Ray ray{origin, direction, near, infinity};
      canvas.put_pixel(x, y, trace_ray(scene, triangles, ray));
    }
  }
}

}  // namespace
}  // namespace cgpp_15_4_measured_light

namespace textbook {
extern const Listing cgpp_15_4_measured_light;
const Listing cgpp_15_4_measured_light{
    .label = "measured light",
    .source = "CGPP 15.4",
    .shows = "Models by rays, with lights whose power spreads, and "
             "shadows.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {"shadow-epsilon", "near"},
    .draws = {.models = true,
              .light = true,
              .light_colours = true,
              .tints = true,
              .shadows = true},
    .as_settings =
        [](Settings& settings) {
          settings.illumination = Illumination::radiometric;
          settings.highlight = Highlight::blinn_phong;
          settings.triangle_test = TriangleTest::moeller_trumbore;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.triangles ? 1 : 0;
        },
    .draw = ps::cgpp_15_4_measured_light::draw,
};
}  // namespace textbook
}  // namespace ps
