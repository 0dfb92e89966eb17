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

// Distance along the ray and three weights, by Cramer's rule; infinity for a ray that passes by, or that meets the
// back of a triangle with one side.
double intersect(const Vec3d& origin, const Vec3d& direction, const Triangle& triangle, Vec3d& weights) {
  const auto& [v0, v1, v2] = triangle.vertices;
  const Vec3d e1 = v1 - v0, e2 = v2 - v0;
  const Vec3d q = cross(direction, e2);
  const double a = dot(e1, q);
  PS_WATCH("a", a);  // above 0 in front of the triangle
  if (a == 0 || (a < 0 && triangle.sides == Sides::front)) return infinity;
  const Vec3d s = origin - v0;
  const Vec3d r = cross(s, e1);
  weights.y = dot(s, q) / a;
  weights.z = dot(direction, r) / a;
  weights.x = 1 - weights.y - weights.z;
  PS_WATCH("weights", weights);
  if (weights.y < 0 || weights.z < 0 || weights.y + weights.z > 1) return infinity;
  const double t = dot(e2, r) / a;
  PS_WATCH("t", t);
  return t;
}

// The nearest triangle along the ray, between t_min and t_max.
const Triangle* nearest(const std::vector<Triangle>& triangles, const Vec3d& origin, const Vec3d& direction,
                        double t_min, double t_max, double& closest_t, Vec3d& closest_weights) {
  const Triangle* closest = nullptr;
  closest_t = t_max;
  for (const Triangle& triangle : triangles) {
    PS_EACH("triangle of", triangle.object);
    PS_WATCH("number", triangle.number);
    Vec3d weights(0);
    const double t = intersect(origin, direction, triangle, weights);
    if (t <= t_min || t >= closest_t) continue;
    closest = &triangle;
    closest_t = t;
    closest_weights = weights;
    PS_WATCH("closest t so far", t);
  }
  return closest;
}

// Which share of the light from one direction a surface scatters to another one: Lambert's law and a highlight that
// is brighter the sharper it is.
// Lights may have another colour in highlights.
Vec3d scattered(const Material& material, const Light& light, const Vec3d& normal, const Vec3d& to_light,
                const Vec3d& to_eye) {
  Vec3d share = material.colour / pi * light.colour;
  if (material.specular) {
    const Vec3d half = to_light / length(to_light) + to_eye / length(to_eye);
    const double cosine = dot(normal, half) / (length(normal) * length(half));
    PS_WATCH("N . H", cosine);
    const double s = *material.specular;
    if (cosine > 0)
      share += material.specular_colour.value_or(material.colour) * ((s + 8) / (8 * pi) * power(cosine, s)) *
               highlight_colour(light);
  }
  return share;
}

// The radiance towards the eye: what the lights send that reaches the point and is scattered there.
Vec3d shade(const BookScene& scene, const std::vector<Triangle>& triangles, const Vec3d& point, const Vec3d& normal,
            const Vec3d& to_eye, const Material& material) {
  Vec3d radiance(0);
  for (const Light& light : scene.lights) {
    PS_EACH("light", kind_name(light));
    if (light.kind == LightKind::ambient) {
      radiance += material.ambient_colour.value_or(material.colour) * light.colour * light.intensity;
      continue;
    }
    const bool is_point = light.kind == LightKind::point;
    const Vec3d to_light = is_point ? light.position - point : light.direction;
    PS_WATCH("to light", to_light);
    // A point light spreads its power over a sphere.
    const double distance = length(to_light);
    const double arriving = is_point ? light.intensity / (4 * pi * distance * distance) : light.intensity;
    radiance += material.ambient_colour.value_or(material.colour) * light.ambient_colour * arriving;

    double t = 0;
    Vec3d unused(0);
    const Triangle* blocker =
        nearest(triangles, point, to_light, scene.settings.shadow_epsilon, is_point ? 1 : infinity, t, unused);
    PS_WATCH("blocked by", blocker ? blocker->object : "nothing");
    if (blocker) continue;

    PS_WATCH("arriving", arriving);
    // A surface at an angle catches less of it.
    const double cosine = dot(normal, to_light) / (length(normal) * distance);
    PS_WATCH("cosine", cosine);
    if (cosine <= 0) continue;
    radiance += scattered(material, light, normal, to_light, to_eye) * (arriving * cosine);
    PS_WATCH("radiance so far", radiance);
  }
  return radiance;
}

Vec3d trace_ray(const BookScene& scene, const std::vector<Triangle>& triangles, const Vec3d& origin,
                const Vec3d& direction) {
  double t = 0;
  Vec3d weights(0);
  const Triangle* hit = nearest(triangles, origin, direction, scene.settings.near, infinity, t, weights);
  if (!hit) return scene.background;
  const auto &v = hit->vertices, &n = hit->normals;
  const Vec3d point = v[0] * weights.x + v[1] * weights.y + v[2] * weights.z;
  PS_WATCH("point", point);
  const Vec3d normal = n[0] * weights.x + n[1] * weights.y + n[2] * weights.z;
  PS_WATCH("normal", normal);
  PS_WATCH("surface colour", hit->material.colour * 255.0);
  const Vec3d radiance = shade(scene, triangles, point, normal, -direction, hit->material);
  PS_WATCH("radiance", radiance);
  return radiance * 255.0;
}

std::vector<Triangle> triangles_of(const BookScene& scene) {
  std::vector<Triangle> all;
  for (const BookInstance& instance : scene.instances) {
    const Mesh& model = *instance.model;
    const Transform& t = instance.instance->transform;
    const Mat4d turned = rotation_matrix(t.rotation);
    const Mat4d place = translation_matrix(t.translation) * (turned * scale_matrix(t.scale));
    for (const MeshTriangle& triangle : model.triangles) {
      Triangle made{{}, {}, {}, instance.instance->sides, instance.name, instance.number_of(triangle)};
      made.material =
          scene.scene.materials->at(instance.instance->material.value_or(model.materials.at(triangle.material)));
      for (std::size_t k = 0; k < 3; ++k) made.vertices[k] = transform(place, model.positions[triangle.position[k]]);
      const Vec3d flat = cross(made.vertices[1] - made.vertices[0], made.vertices[2] - made.vertices[0]);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t own = triangle.normal[k];
        const Vec3d normal = own < 0 ? flat : turn(turned, model.normals[static_cast<std::size_t>(own)]);
        made.normals[k] = normal / length(normal);
      }
      all.push_back(made);
    }
  }
  return all;
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const std::vector<Triangle> triangles = triangles_of(scene);
  const Camera& camera = scene.camera;
  for (int y = canvas.bottom(); y < canvas.top(); ++y) {
    for (int x = canvas.left(); x < canvas.right(); ++x) {
      PS_PIXEL(x, y);
      const Vec3d direction = camera.right * (x * camera.viewport_width / scene.width) +
                              camera.up * (y * camera.viewport_height / scene.height) +
                              camera.forward * camera.projection_plane_d;
      PS_WATCH("direction", direction);
      canvas.put_pixel(x, y, trace_ray(scene, triangles, camera.position, direction));
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
    .shows = "Models by rays, with lights whose power spreads, and shadows.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {"shadow-epsilon", "near"},
    .draws = {.models = true, .light = true, .light_colours = true, .tints = true, .shadows = true},
    .as_settings =
        [](Settings& settings) {
          settings.illumination = Illumination::radiometric;
          settings.highlight = Highlight::blinn_phong;
          settings.triangle_test = TriangleTest::moeller_trumbore;
        },
    .suits = [](const SceneTraits& traits, const Settings&) { return traits.triangles ? 1 : 0; },
    .draw = ps::cgpp_15_4_measured_light::draw,
};
}  // namespace textbook
}  // namespace ps
