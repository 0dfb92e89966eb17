// The cubes are seen from a place where the camera is not.
#include <array>
#include <cmath>
#include <utility>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_10_scenes {
namespace {

// As in chapter 6, with its interpolate().
void draw_line(BookCanvas& canvas, Vec2d p0, Vec2d p1, const Vec3d& colour) {
  if (std::abs(p1.x - p0.x) > std::abs(p1.y - p0.y)) {
    if (p1.x < p0.x) std::swap(p0, p1);
    const auto ys = interpolate(p0.x, p0.y, p1.x, p1.y);
    for (double x = p0.x; x <= p1.x; ++x) {
      const double y = entry(ys, x, p0.x);
      PS_PIXEL(x, y);
      PS_WATCH("place", Vec2d(x, y));
      canvas.put_pixel(x, y, colour);
      PS_WATCH("colour", colour);
    }
  } else {
    if (p1.y < p0.y) std::swap(p0, p1);
    const auto xs = interpolate(p0.y, p0.x, p1.y, p1.x);
    for (double y = p0.y; y <= p1.y; ++y) {
      const double x = entry(xs, y, p0.y);
      PS_PIXEL(x, y);
      PS_WATCH("place", Vec2d(x, y));
      canvas.put_pixel(x, y, colour);
      PS_WATCH("colour", colour);
    }
  }
}

// Model to world to camera: scale, rotate, move, then undo what the camera did.
Mat4d model_to_camera(const BookScene& scene, const Transform& t) {
  const Mat4d model = translation_matrix(t.translation) * (rotation_matrix(t.rotation) * scale_matrix(t.scale));
  const Mat4d camera = translation_matrix(-scene.camera.position) * camera_rotation_inverse(scene.camera);
  return camera * model;
}

// From camera space to the canvas: divide by the distance, then scale the viewport to the canvas.
Vec2d project(const BookScene& scene, const Vec3d& p) {
  const Camera& camera = scene.camera;
  const Vec2d on_viewport{p.x * camera.projection_plane_d / p.z, p.y * camera.projection_plane_d / p.z};
  PS_WATCH("on the viewport", on_viewport);
  return {on_viewport.x * scene.width / camera.viewport_width, on_viewport.y * scene.height / camera.viewport_height};
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Mat4d to_camera = model_to_camera(scene, instance.instance->transform);

    for (const MeshTriangle& triangle : instance.model->triangles) {
      PS_REACHING("triangle", instance.number_of(triangle));
      std::array<Vec2d, 3> p;
      bool in_front = true;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        const Vec3d vertex = instance.model->positions[triangle.position[k]];
        PS_WATCH("in the model", vertex);
        const Vec3d seen = transform(to_camera, vertex);
        PS_WATCH("from the camera", seen);
        in_front = in_front && seen.z > 0;
        p[k] = project(scene, seen);
        PS_WATCH("on the canvas", p[k]);
      }
      if (!in_front || canvas.far_outside(p[0]) || canvas.far_outside(p[1]) || canvas.far_outside(p[2])) continue;
      const Vec3d colour = surface_of(scene, instance, triangle).colour;
      draw_line(canvas, p[0], p[1], colour);
      draw_line(canvas, p[1], p[2], colour);
      draw_line(canvas, p[0], p[2], colour);
    }
  }
}

}  // namespace
}  // namespace cgfs_10_scenes

namespace textbook {
extern const Listing cgfs_10_scenes;
const Listing cgfs_10_scenes{
    .label = "wireframe scenes",
    .source = "CGFS ch. 9 and 10",
    .shows = "Models in their places, projected and drawn as the edges of their triangles.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.models = true},
    .as_settings = [](Settings& settings) { settings.draw = Draw::wireframe; },
    .suits = [](const SceneTraits& traits,
                const Settings& settings) { return !traits.triangles                  ? 0
                                                   : settings.draw == Draw::wireframe ? 6
                                                                                      : 1; },
    .draw = ps::cgfs_10_scenes::draw,
};
}  // namespace textbook
}  // namespace ps
