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
void draw_line(BookCanvas& canvas, Vec2d p0, Vec2d p1,
               Vec3d colour) {
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

// Model to world to camera: scale, rotate and move the model, then
// undo what the camera did. The matrix on the right acts first.
Mat4d model_to_camera(const BookScene& scene, const Transform& t) {
  const Mat4d scale = scale_matrix(t.scale);
  const Mat4d rotate = rotation_matrix(t.rotation);
  const Mat4d move = translation_matrix(t.translation);
  const Mat4d model = move * (rotate * scale);

  const Camera& seen_by = scene.camera;
  const Mat4d move_back = translation_matrix(-seen_by.position);
  const Mat4d rotate_back = camera_rotation_inverse(seen_by);
  const Mat4d camera = rotate_back * move_back;
  return camera * model;
}

// From camera space to the canvas: divide by the distance, then
// scale the viewport to the canvas.
Vec2d project(const BookScene& scene, const Vec3d& p) {
  const Camera& camera = scene.camera;
  const double x = p.x * camera.projection_plane_d / p.z;
  const double y = p.y * camera.projection_plane_d / p.z;
  PS_WATCH("on the viewport", Vec2d(x, y));
  return {x * scene.width / camera.viewport_width,
          y * scene.height / camera.viewport_height};
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Transform& place = instance.instance->transform;
    const Mat4d to_camera = model_to_camera(scene, place);
    const auto& positions = instance.model->positions;

    for (const MeshTriangle& face : instance.model->triangles) {
      PS_REACHING("triangle", instance.number_of(face));
      std::array<Vec2d, 3> p;
      bool drawn = true;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        const Vec3d vertex = positions[face.position[k]];
        PS_WATCH("in the model", vertex);
        const Vec3d seen = transform(to_camera, vertex);
        PS_WATCH("from the camera", seen);
        p[k] = project(scene, seen);
        PS_WATCH("on the canvas", p[k]);
        drawn = drawn && seen.z > 0 && !canvas.far_outside(p[k]);
      }
      if (!drawn) continue;
      const Vec3d colour = surface_of(scene, instance, face).colour;
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
    .shows = "Models in their places, projected and drawn as the "
             "edges of their triangles.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.models = true},
    .as_settings =
        [](Settings& settings) { settings.draw = Draw::wireframe; },
    .suits =
        [](const SceneTraits& traits, const Settings& settings) {
          if (!traits.triangles) return 0;
          return settings.draw == Draw::wireframe ? 6 : 1;
        },
    .draw = ps::cgfs_10_scenes::draw,
};
}  // namespace textbook
}  // namespace ps
