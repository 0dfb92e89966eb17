#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_11_clipping {
namespace {

using Triangle = std::array<Vec3d, 3>;  // as the camera sees it
using Triangles = std::vector<Triangle>;

// Points in front of it have a positive signed distance.
struct Plane {
  std::string_view name;
  Vec3d normal{0, 0, 1};  // of length 1, pointing inwards
  double d = 0;

  double distance(const Vec3d& p) const {
    return dot(normal, p) + d;
  }
};

// The near plane, and four through the edges of the picture, which
// has a margin of one pixel.
std::vector<Plane> clipping_planes(const BookScene& scene) {
  const double d = scene.camera.projection_plane_d;
  const double vw = scene.camera.viewport_width;
  const double vh = scene.camera.viewport_height;
  const double x = (scene.width / 2.0 + 1) * vw / scene.width / d;
  const double y = (scene.height / 2.0 + 1) * vh / scene.height / d;
  const double near = scene.settings.near * d;
  std::vector<Plane> planes{{"near", {0, 0, 1}, -near},
                            {"left", {1, 0, x}, 0},
                            {"right", {-1, 0, x}, 0},
                            {"top", {0, -1, y}, 0},
                            {"bottom", {0, 1, y}, 0}};
  for (Plane& plane : planes)
    plane.normal = plane.normal / length(plane.normal);
  return planes;
}

// Where the way from a, in front of the plane, to b, behind it,
// meets the plane.
Vec3d intersection(Vec3d a, Vec3d b, const Plane& plane) {
  const Vec3d n = plane.normal;
  const double t = (-plane.d - dot(n, a)) / dot(n, b - a);
  PS_WATCH("t", t);
  return a + (b - a) * t;
}

// Adds the part of a triangle in front of the plane: none, one or
// two triangles.
void clip_triangle(const Triangle& triangle, const Plane& plane,
                   Triangles& result) {
  auto [a, b, c] = triangle;
  const auto front = [&](const Vec3d& p) {
    return plane.distance(p) >= 0;
  };
  const int in_front = front(a) + front(b) + front(c);
  PS_WATCH("vertices in front", in_front);
  if (in_front == 3) result.push_back(triangle);
  if (in_front == 1) {
    // Turn the triangle until a is the vertex in front.
    while (!front(a)) std::swap(a, b), std::swap(b, c);
    const Vec3d b2 = intersection(a, b, plane);
    const Vec3d c2 = intersection(a, c, plane);
    result.push_back({a, b2, c2});
  }
  if (in_front == 2) {
    // Turn the triangle until c is the vertex behind.
    while (front(c)) std::swap(a, b), std::swap(b, c);
    const Vec3d a2 = intersection(a, c, plane);
    const Vec3d b2 = intersection(b, c, plane);
    result.push_back({a, b, a2});
    result.push_back({a2, b, b2});
  }
}

// All planes in turn, each of what the one before has left.
Triangles clip(const Triangle& triangle,
               const std::vector<Plane>& planes) {
  Triangles kept{triangle};
  for (const Plane& plane : planes) {
    PS_EACH("plane", plane.name);
    Triangles result;
    for (const Triangle& each : kept)
      clip_triangle(each, plane, result);
    kept = result;
    PS_WATCH("triangles left", kept.size());
  }
  return kept;
}

// A place on the canvas, rounded to 1/256 of a pixel.
Vec2d project(const BookScene& scene, const Vec3d& p) {
  const double d = scene.camera.projection_plane_d;
  const double vw = scene.camera.viewport_width;
  const double vh = scene.camera.viewport_height;
  const double x = p.x * d / p.z * scene.width / vw;
  const double y = p.y * d / p.z * scene.height / vh;
  return {std::nearbyint(x * 256) / 256,
          std::nearbyint(y * 256) / 256};
}

// Twice the area of the triangle a, b, p.
double edge(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

void fill(BookCanvas& canvas, Vec2d a, Vec2d b, Vec2d c,
          Vec3d colour) {
  const double turn = edge(a, b, c) < 0 ? -1 : 1;
  if (edge(a, b, c) == 0) return;
  const auto [x_low, x_high] = std::minmax({a.x, b.x, c.x});
  const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
  const int x0 = std::max(canvas.left(), round_up(x_low));
  const int x1 = std::min(canvas.right() - 1, round_down(x_high));
  const int y0 = std::max(canvas.bottom(), round_up(y_low));
  const int y1 = std::min(canvas.top() - 1, round_down(y_high));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const Vec2d p(x, y);
      const double ab = turn * edge(a, b, p);
      const double bc = turn * edge(b, c, p);
      const double ca = turn * edge(c, a, p);
      if (ab < 0 || bc < 0 || ca < 0) continue;
      PS_PIXEL(x, y);
      canvas.put_pixel(x, y, colour);
      PS_WATCH("colour", colour);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const std::vector<Plane> planes = clipping_planes(scene);
  const Mat4d to_camera = world_to_camera(scene.camera);
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Transform& t = instance.instance->transform;
    const Mat4d to_world = model_to_world(t);
    const auto& positions = instance.model->positions;

    for (const MeshTriangle& face : instance.model->triangles) {
      PS_REACHING("triangle", instance.number_of(face));
      Triangle v;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        const Vec3d& vertex = positions[face.position[k]];
        v[k] = transform(to_camera, transform(to_world, vertex));
        PS_WATCH("from the camera", v[k]);
      }
      const Vec3d normal = cross(v[1] - v[0], v[2] - v[0]);
      const bool back = dot(-v[0], normal) <= 0;
      if (back && scene.settings.backface_culling) continue;
      const Vec3d colour = surface_of(scene, instance, face).colour;
      for (const Triangle& part : clip(v, planes)) {
        PS_REACHING("part with vertex", part[0]);
        const Vec2d a = project(scene, part[0]);
        const Vec2d b = project(scene, part[1]);
        const Vec2d c = project(scene, part[2]);
        fill(canvas, a, b, c, colour);
      }
    }
  }
}

}  // namespace
}  // namespace cgfs_11_clipping

namespace textbook {
extern const Listing cgfs_11_clipping;
const Listing cgfs_11_clipping{
    .label = "clipping",
    .source = "CGFS ch. 11",
    .shows = "Models in plain colours, in the order in which they "
             "come, cut at the planes of the view.",
    .order = ListingOrder::object_by_object,
    .reads = {"backface-culling", "near"},
    .draws = {.models = true},
    .as_settings =
        [](Settings& settings) {
          settings.clipping = Clipping::full;
          settings.visibility = Visibility::draw_order;
          settings.subpixel_bits = 8;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.triangles ? 1 : 0;
        },
    .draw = ps::cgfs_11_clipping::draw,
};
}  // namespace textbook
}  // namespace ps
