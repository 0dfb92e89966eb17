#include <array>
#include <limits>
#include <vector>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_05_solids {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Ray {
  Vec3d origin, direction;
  double t_min = 1;
};

// The points p of a plane have dot(normal, p) = distance.
struct Plane {
  Vec3d normal;
  double distance = 0;
};

using Corners = std::array<Vec3d, 3>;

struct Triangle {
  Corners v;  // in the world
  Vec3d colour;
};

using Triangles = std::vector<Triangle>;

// The plane that contains the triangle.
Plane plane_of(const Corners& v) {
  const Vec3d normal = cross(v[1] - v[0], v[2] - v[0]);
  PS_WATCH("normal", normal);
  return {normal, dot(normal, v[0])};
}

// Where the ray meets the plane: nowhere if they are parallel.
double intersect_ray_plane(const Ray& ray, const Plane& plane) {
  const double nearing = dot(plane.normal, ray.direction);
  PS_WATCH("nearing", nearing);
  if (nearing == 0) return infinity;
  const double gap = plane.distance - dot(plane.normal, ray.origin);
  return gap / nearing;
}

// Whether a point of the plane is on the inside of all edges.
bool is_inside(const Corners& v, Vec3d normal, Vec3d p) {
  for (std::size_t i = 0; i < 3; ++i) {
    PS_EACH("edge from vertex", i);
    const Vec3d edge = v[(i + 1) % 3] - v[i];
    const double side = dot(cross(edge, p - v[i]), normal);
    PS_WATCH("side", side);
    if (side < 0) return false;
  }
  return true;
}

double intersect_ray_triangle(const Ray& ray, const Corners& v) {
  const Plane plane = plane_of(v);
  const double t = intersect_ray_plane(ray, plane);
  PS_WATCH("t of the plane", t);
  if (t == infinity) return infinity;
  const Vec3d p = ray.origin + ray.direction * t;
  PS_WATCH("point of the plane", p);
  return is_inside(v, plane.normal, p) ? t : infinity;
}

// As in chapter 2, with triangles in place of spheres. Null: none.
const Triangle* trace_ray(const Triangles& all, const Ray& ray) {
  double closest_t = infinity;
  const Triangle* closest = nullptr;
  for (const Triangle& triangle : all) {
    PS_EACH("triangle", &triangle - all.data());
    const double t = intersect_ray_triangle(ray, triangle.v);
    if (t <= ray.t_min || t >= closest_t) continue;
    closest_t = t;
    closest = &triangle;
    PS_WATCH("closest t so far", closest_t);
  }
  return closest;
}

Triangles triangles_of(const BookScene& scene) {
  Triangles all;
  for (const BookInstance& instance : scene.instances) {
    const Transform& t = instance.instance->transform;
    const Mat4d place = model_to_world(t);
    const auto& positions = instance.model->positions;
    for (const MeshTriangle& mesh : instance.model->triangles) {
      Triangle triangle;
      triangle.colour = surface_of(scene, instance, mesh).colour;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& vertex = positions[mesh.position[k]];
        triangle.v[k] = transform(place, vertex);
      }
      all.push_back(triangle);
    }
  }
  return all;
}

// From the eye through a place of the canvas.
Ray eye_ray(const BookScene& scene, int x, int y) {
  const Camera& camera = scene.camera;
  const double across = x * camera.viewport_width / scene.width;
  const double up = y * camera.viewport_height / scene.height;
  const Vec3d ahead = camera.forward * camera.projection_plane_d;
  const Vec3d aside = camera.right * across + camera.up * up;
  return {camera.position, aside + ahead, scene.settings.near};
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const Triangles triangles = triangles_of(scene);
  for (int y = canvas.bottom(); y < canvas.top(); ++y) {
    for (int x = canvas.left(); x < canvas.right(); ++x) {
      PS_PIXEL(x, y);
      const Ray ray = eye_ray(scene, x, y);
      PS_WATCH("direction", ray.direction);
      const Triangle* hit = trace_ray(triangles, ray);
      const Vec3d colour = hit ? hit->colour : scene.background;
      PS_WATCH("colour", colour);
      canvas.put_pixel(x, y, colour);
    }
  }
}

}  // namespace
}  // namespace cgfs_05_solids

namespace textbook {
extern const Listing cgfs_05_solids;
const Listing cgfs_05_solids{
    .label = "ray and triangle",
    .source = "CGFS ch. 5",
    .shows = "Models in plain colours by rays: the plane of a "
             "triangle, then its three edges.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {"near"},
    .draws = {.models = true},
    .as_settings =
        [](Settings& settings) {
          settings.triangle_test = TriangleTest::cross_products;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.triangles ? 1 : 0;
        },
    .draw = ps::cgfs_05_solids::draw,
};
}  // namespace textbook
}  // namespace ps
