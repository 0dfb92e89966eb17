#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgpp_15_6_which_pixels {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Vertices as the camera sees them: z is the distance along its
// view. Places on the canvas are counted from its centre.
using Corners = std::array<Vec3d, 3>;
using Points = std::array<Vec2d, 3>;

struct Triangle {
  Corners v;
  Vec3d colour;
};

struct Box {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;  // the last ones are left out
};

Box whole_screen(const BookCanvas& canvas) {
  Box box{canvas.left(), canvas.right(), 0, 0};
  box.y0 = canvas.bottom();
  box.y1 = canvas.top();
  return box;
}

Vec3d compute_eye_ray(const BookScene& scene, int x, int y) {
  const Camera& camera = scene.camera;
  const double across = x * camera.viewport_width / scene.width;
  const double up = y * camera.viewport_height / scene.height;
  return {across, up, camera.projection_plane_d};
}

// The ray's parameter where it meets the triangle, or infinity.
double intersect(const Vec3d& direction, const Corners& v) {
  const Vec3d e1 = v[1] - v[0];
  const Vec3d e2 = v[2] - v[0];
  const Vec3d q = cross(direction, e2);
  const double a = dot(e1, q);
  if (a == 0) return infinity;
  const Vec3d s = -v[0];
  const Vec3d r = cross(s, e1);
  const double w1 = dot(s, q) / a;
  const double w2 = dot(direction, r) / a;
  PS_WATCH("weights", Vec3d(1 - w1 - w2, w1, w2));
  if (w1 < 0 || w2 < 0 || w1 + w2 > 1) return infinity;
  return dot(e2, r) / a;
}

// The distance along the eye ray, if the ray meets the triangle.
double sample_ray_triangle(const Vec3d& ray, const Corners& v) {
  const double t = intersect(ray, v);
  return t > 0 && t < infinity ? t * length(ray) : infinity;
}

Vec2d perspective_project(const BookScene& scene, const Vec3d& p) {
  const Camera& camera = scene.camera;
  const double d = camera.projection_plane_d;
  const double x = p.x * d / p.z / camera.viewport_width;
  const double y = p.y * d / p.z / camera.viewport_height;
  return {x * scene.width, y * scene.height};
}

Points project_all(const BookScene& scene, const Corners& v) {
  Points projected;
  for (std::size_t k = 0; k < 3; ++k) {
    projected[k] = perspective_project(scene, v[k]);
  }
  PS_WATCH("vertex 0 on the canvas", projected[0]);
  PS_WATCH("vertex 1 on the canvas", projected[1]);
  PS_WATCH("vertex 2 on the canvas", projected[2]);
  return projected;
}

int within(double place, int low, int high) {
  if (!(place > low)) return low;
  return place < high ? static_cast<int>(place) : high;
}

// The box around the projected vertices, within the screen.
Box compute_bounding_box(const Points& p, const Box& screen) {
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
  const int x0 = screen.x0, x1 = screen.x1;
  const int y0 = screen.y0, y1 = screen.y1;
  Box box;
  box.x0 = within(std::ceil(left), x0, x1);
  box.x1 = within(std::floor(right) + 1, x0, x1);
  box.y0 = within(std::ceil(low), y0, y1);
  box.y1 = within(std::floor(high) + 1, y0, y1);
  return box;
}

struct Picture {
  const BookScene& scene;
  BookCanvas& canvas;
};

// A fragment: the nearest one so far gets the pixel.
void merge(BookCanvas& to, Vec2i at, double distance, Vec3d ink) {
  PS_WATCH("distance", distance);
  if (!to.nearer(at.x, at.y, 1 / distance)) return;
  to.put_pixel(at.x, at.y, ink);
  PS_WATCH("colour", ink);
}

// The first loops: rays, in the screen or in a smaller box.
void rasterize_by_rays(Picture& to, const Triangle& t, Box box) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      PS_PIXEL(x, y);
      const Vec3d ray = compute_eye_ray(to.scene, x, y);
      PS_WATCH("eye ray", ray);
      const double distance = sample_ray_triangle(ray, t.v);
      if (distance == infinity) continue;
      merge(to.canvas, {x, y}, distance, t.colour);
    }
  }
}

// The distance from q to the line through a and b, with a sign.
double line_distance(Vec2d a, Vec2d b, Vec2d q) {
  const Vec2d n(a.y - b.y, b.x - a.x);
  const double d = a.x * b.y - b.x * a.y;
  const double size = std::sqrt(n.x * n.x + n.y * n.y);
  return (n.x * q.x + n.y * q.y + d) / size;
}

// The weight of vertex a at q.
double bary(Vec2d a, Vec2d b, Vec2d c, Vec2d q) {
  const double height = line_distance(b, c, a);
  return line_distance(b, c, q) / height;
}

// The third loop: weights on the canvas in place of rays.
void rasterize_by_weights(Picture& to, const Triangle& t, Box box) {
  const Points p = project_all(to.scene, t.v);
  if (line_distance(p[0], p[1], p[2]) == 0) return;
  // Attributes divided by z are linear on the canvas.
  std::array<double, 3> vw;
  Corners vp;
  for (std::size_t k = 0; k < 3; ++k) {
    vw[k] = 1 / t.v[k].z;
    vp[k] = t.v[k] * vw[k];
  }
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      PS_PIXEL(x, y);
      const Vec2d q(x, y);
      const double w0 = bary(p[0], p[1], p[2], q);
      const double w1 = bary(p[1], p[2], p[0], q);
      const double w2 = bary(p[2], p[0], p[1], q);
      PS_WATCH("weights on the canvas", Vec3d(w0, w1, w2));
      if (!(w0 > 0 && w1 > 0 && w2 > 0)) continue;
      const double w = w0 * vw[0] + w1 * vw[1] + w2 * vw[2];
      const Vec3d pw = w0 * vp[0] + w1 * vp[1] + w2 * vp[2];
      PS_WATCH("point", pw / w);
      const double distance = length(pw / w);
      merge(to.canvas, {x, y}, distance, t.colour);
    }
  }
}

void rasterize(Picture& to, const Triangle& t) {
  const Box screen = whole_screen(to.canvas);
  const Points p = project_all(to.scene, t.v);
  const Box box = compute_bounding_box(p, screen);
  const Coverage coverage = to.scene.settings.coverage;
  if (coverage == Coverage::ray_test)
    rasterize_by_rays(to, t, screen);
  else if (coverage == Coverage::bounding_box)
    rasterize_by_rays(to, t, box);
  else
    rasterize_by_weights(to, t, box);
}

Vec3d seen_from(const Camera& camera, const Vec3d& p) {
  const Vec3d way = p - camera.position;
  const double x = dot(way, camera.right), y = dot(way, camera.up);
  return {x, y, dot(way, camera.forward)};
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  Picture to{scene, canvas};
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Transform& t = instance.instance->transform;
    const Mat4d place = model_to_world(t);
    const auto& positions = instance.model->positions;
    for (const MeshTriangle& mesh : instance.model->triangles) {
      PS_REACHING("triangle", instance.number_of(mesh));
      Triangle triangle;
      triangle.colour = surface_of(scene, instance, mesh).colour;
      bool in_front = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& vertex = positions[mesh.position[k]];
        const Vec3d world = transform(place, vertex);
        triangle.v[k] = seen_from(scene.camera, world);
        in_front = in_front && triangle.v[k].z > 0;
      }
      // Triangles that reach behind the camera need clipping first.
      if (in_front) rasterize(to, triangle);
    }
  }
}

}  // namespace
}  // namespace cgpp_15_6_which_pixels

namespace textbook {
extern const Listing cgpp_15_6_which_pixels;
const Listing cgpp_15_6_which_pixels{
    .label = "three coverage loops",
    .source = "CGPP 15.6",
    .shows = "Models in plain colours: every pixel asked by a ray, "
             "then those of a box, then by weights on the canvas.",
    .order = ListingOrder::object_by_object,
    .reads = {"coverage"},
    .draws = {.models = true},
    .as_settings =
        [](Settings& settings) {
          settings.backface_culling = false;
          settings.subpixel_bits = 12;
          settings.depth_value = DepthValue::distance;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.triangles ? 1 : 0;
        },
    .draw = ps::cgpp_15_6_which_pixels::draw,
};
}  // namespace textbook
}  // namespace ps
