// What the near plane cuts ends too early.
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

using Triangle = std::array<Vec3d, 3>;  // as seen from the camera

// Points in front of it have a positive signed distance.
struct Plane {
  std::string_view name;
  Vec3d normal{0, 0, 1};  // of length 1, pointing inwards
  double d = 0;

  double distance(const Vec3d& p) const { return dot(normal, p) + d; }
};

// The near plane, and four through the edges of the picture, which has a margin of one pixel.
std::vector<Plane> clipping_planes(const BookScene& scene) {
  const Camera& camera = scene.camera;
  const double x = (scene.width / 2.0 + 1) * camera.viewport_width / scene.width / camera.projection_plane_d;
  const double y = (scene.height / 2.0 + 1) * camera.viewport_height / scene.height / camera.projection_plane_d;
  std::vector<Plane> planes{{"near", {0, 0, 1}, -scene.settings.near * camera.projection_plane_d},
                            {"left", {1, 0, x}, 0},
                            {"right", {-1, 0, x}, 0},
                            {"top", {0, -1, y}, 0},
                            {"bottom", {0, 1, y}, 0}};
  for (Plane& plane : planes) plane.normal = plane.normal / length(plane.normal);
  return planes;
}

// Where the way from a, in front of the plane, to b, behind it, meets the plane.
Vec3d intersection(const Vec3d& a, const Vec3d& b, const Plane& plane) {
  const double t = (-plane.d - dot(plane.normal, a)) / dot(plane.normal, b - a);
  PS_WATCH("t", t);
  return b + (a - b) * t;
}

// Adds the part of a triangle in front of the plane: none, one or two triangles.
void clip_triangle(const Triangle& triangle, const Plane& plane, std::vector<Triangle>& result) {
  auto [a, b, c] = triangle;
  const auto front = [&](const Vec3d& p) { return plane.distance(p) >= 0; };
  const int in_front = front(a) + front(b) + front(c);
  PS_WATCH("vertices in front", in_front);
  if (in_front == 3) result.push_back(triangle);
  if (in_front == 1) {
    while (!front(a)) std::swap(a, b), std::swap(b, c);  // a becomes the one in front
    result.push_back({a, intersection(a, b, plane), intersection(a, c, plane)});
  }
  if (in_front == 2) {
    while (front(c)) std::swap(a, b), std::swap(b, c);  // c becomes the one behind
    const Vec3d a2 = intersection(a, c, plane), b2 = intersection(b, c, plane);
    result.push_back({a, b, a2});
    result.push_back({a2, b, b2});
  }
}

// All planes one after the other, each of what the one before has left.
std::vector<Triangle> clip(const Triangle& triangle, const std::vector<Plane>& planes) {
  std::vector<Triangle> kept{triangle};
  for (const Plane& plane : planes) {
    PS_EACH("plane", plane.name);
    std::vector<Triangle> result;
    for (const Triangle& each : kept) clip_triangle(each, plane, result);
    kept = result;
    PS_WATCH("triangles left", kept.size());
  }
  return kept;
}

// A place on the canvas, rounded to 1/256 of a pixel.
Vec2d project(const BookScene& scene, const Vec3d& p) {
  const Camera& camera = scene.camera;
  const double x = p.x * camera.projection_plane_d / p.z * scene.width / camera.viewport_width;
  const double y = p.y * camera.projection_plane_d / p.z * scene.height / camera.viewport_height;
  return {std::nearbyint(x * 256) / 256, std::nearbyint(y * 256) / 256};
}

// Twice the area of the triangle a, b, p.
double edge(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

void fill(BookCanvas& canvas, const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec3d& colour) {
  const double turn = edge(a, b, c) < 0 ? -1 : 1;
  if (edge(a, b, c) == 0) return;
  const auto [x_low, x_high] = std::minmax({a.x, b.x, c.x});
  const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
  const int left = std::max(canvas.left(), static_cast<int>(std::ceil(x_low)));
  const int right = std::min(canvas.right() - 1, static_cast<int>(std::floor(x_high)));
  const int low = std::max(canvas.bottom(), static_cast<int>(std::ceil(y_low)));
  const int high = std::min(canvas.top() - 1, static_cast<int>(std::floor(y_high)));
  for (int y = low; y <= high; ++y) {
    for (int x = left; x <= right; ++x) {
      const Vec2d p(x, y);
      if (turn * edge(a, b, p) < 0 || turn * edge(b, c, p) < 0 || turn * edge(c, a, p) < 0) continue;
      PS_PIXEL(x, y);
      canvas.put_pixel(x, y, colour);
      PS_WATCH("colour", colour);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const std::vector<Plane> planes = clipping_planes(scene);
  const Mat4d to_camera = camera_rotation_inverse(scene.camera) * translation_matrix(-scene.camera.position);
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Transform& t = instance.instance->transform;
    const Mat4d place = translation_matrix(t.translation) * (rotation_matrix(t.rotation) * scale_matrix(t.scale));

    for (const MeshTriangle& triangle : instance.model->triangles) {
      PS_REACHING("triangle", instance.number_of(triangle));
      Triangle seen;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        seen[k] = transform(to_camera, transform(place, instance.model->positions[triangle.position[k]]));
        PS_WATCH("from the camera", seen[k]);
      }
      const bool back = dot(-seen[0], cross(seen[1] - seen[0], seen[2] - seen[0])) <= 0;
      if (back && scene.settings.backface_culling) continue;
      const Vec3d colour = surface_of(scene, instance, triangle).colour;
      for (const Triangle& part : clip(seen, planes)) {
        PS_REACHING("part with vertex", part[0]);
        fill(canvas, project(scene, part[0]), project(scene, part[1]), project(scene, part[2]), colour);
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
    .shows = "Models in plain colours, in the order in which they come, cut at the planes of the view.",
    .order = ListingOrder::object_by_object,
    .reads = {"backface-culling", "near"},
    .draws = {.models = true},
    .as_settings =
        [](Settings& settings) {
          settings.clipping = Clipping::full;
          settings.visibility = Visibility::draw_order;
          settings.subpixel_bits = 8;
        },
    .suits = [](const SceneTraits& traits, const Settings&) { return traits.triangles ? 1 : 0; },
    .draw = ps::cgfs_11_clipping::draw,
};
}  // namespace textbook
}  // namespace ps
