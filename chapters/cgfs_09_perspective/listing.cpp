#include <array>
#include <cmath>
#include <utility>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_09_perspective {
namespace {

// As in chapter 6, with its interpolate().
void draw_line(BookCanvas& to, Vec2d p0, Vec2d p1, Vec3d colour) {
  if (std::abs(p1.x - p0.x) > std::abs(p1.y - p0.y)) {
    if (p1.x < p0.x) std::swap(p0, p1);
    const auto ys = interpolate(p0.x, p0.y, p1.x, p1.y);
    for (double x = p0.x; x <= p1.x; ++x) {
      const double y = entry(ys, x, p0.x);
      PS_PIXEL(x, y);
      PS_WATCH("place", Vec2d(x, y));
      to.put_pixel(x, y, colour);
      PS_WATCH("colour", colour);
    }
  } else {
    if (p1.y < p0.y) std::swap(p0, p1);
    const auto xs = interpolate(p0.y, p0.x, p1.y, p1.x);
    for (double y = p0.y; y <= p1.y; ++y) {
      const double x = entry(xs, y, p0.y);
      PS_PIXEL(x, y);
      PS_WATCH("place", Vec2d(x, y));
      to.put_pixel(x, y, colour);
      PS_WATCH("colour", colour);
    }
  }
}

// From units of the viewport to pixels of the canvas.
Vec2d viewport_to_canvas(const BookScene& scene, const Vec2d& p) {
  const double vw = scene.camera.viewport_width;
  const double vh = scene.camera.viewport_height;
  return {p.x * scene.width / vw, p.y * scene.height / vh};
}

// One division, by the distance from the camera.
Vec2d project_vertex(const BookScene& scene, const Vec3d& v) {
  const double d = scene.camera.projection_plane_d;
  const double x = v.x * d / v.z;
  const double y = v.y * d / v.z;
  PS_WATCH("on the viewport", Vec2d(x, y));
  return viewport_to_canvas(scene, {x, y});
}

// The camera of the book stands at the origin and looks along z.
Vec3d seen_from(const Camera& camera, const Vec3d& p) {
  const Vec3d way = p - camera.position;
  const double x = dot(way, camera.right), y = dot(way, camera.up);
  return {x, y, dot(way, camera.forward)};
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("cube", instance.name);
    const Transform& t = instance.instance->transform;
    const Mat4d place = model_to_world(t);
    const auto& positions = instance.model->positions;

    for (const MeshTriangle& side : instance.model->triangles) {
      PS_REACHING("triangle", instance.number_of(side));
      std::array<Vec2d, 3> p;
      bool drawn = true;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        const Vec3d& vertex = positions[side.position[k]];
        const Vec3d world = transform(place, vertex);
        const Vec3d v = seen_from(scene.camera, world);
        PS_WATCH("from the camera", v);
        p[k] = project_vertex(scene, v);
        PS_WATCH("on the canvas", p[k]);
        drawn = drawn && v.z > 0 && !canvas.far_outside(p[k]);
      }
      if (!drawn) continue;
      const Vec3d colour = surface_of(scene, instance, side).colour;
      draw_line(canvas, p[0], p[1], colour);
      draw_line(canvas, p[1], p[2], colour);
      draw_line(canvas, p[0], p[2], colour);
    }
  }
}

}  // namespace
}  // namespace cgfs_09_perspective

namespace textbook {
extern const Listing cgfs_09_perspective;
const Listing cgfs_09_perspective{
    .label = "the first cube",
    .source = "CGFS ch. 9",
    .shows = "Models as the edges of their triangles: each vertex "
             "is divided by its distance.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.models = true},
    .as_settings =
        [](Settings& settings) {
          settings.draw = Draw::wireframe;
          settings.line_algorithm = LineAlgorithm::general;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.triangles ? 1 : 0;
        },
    .draw = ps::cgfs_09_perspective::draw,
};
}  // namespace textbook
}  // namespace ps
