#include <array>
#include <cmath>
#include <utility>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_12_hidden_surfaces {
namespace {

using Corners = std::array<Vec3d, 3>;
using Points = std::array<Vec2d, 3>;

Vec2d project(const BookScene& scene, const Vec3d& p) {
  const double d = scene.camera.projection_plane_d;
  const double vw = scene.camera.viewport_width;
  const double vh = scene.camera.viewport_height;
  const double x = p.x * d / p.z * scene.width / vw;
  const double y = p.y * d / p.z * scene.height / vh;
  return {std::trunc(x), std::trunc(y)};
}

// A back face turns its normal away from the camera, which is at
// the origin.
bool is_back_face(const Corners& seen) {
  const Vec3d normal = cross(seen[1] - seen[0], seen[2] - seen[0]);
  const double facing = dot(-seen[0], normal);
  PS_WATCH("to the camera . normal", facing);
  return facing <= 0;
}

// sorted_by_height() and interpolate_edges() are the sort and the
// join of chapter 7.
void draw_triangle(const BookScene& scene, BookCanvas& canvas,
                   const Points& projected, const Corners& seen,
                   Vec3d colour) {
  const Visibility visibility = scene.settings.visibility;
  const bool test_depth = visibility == Visibility::depth_buffer;
  const auto order = sorted_by_height(projected);
  std::array<double, 3> x, y, w;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = projected[order[k]].x;
    y[k] = projected[order[k]].y;
    // 1/z changes evenly across the canvas, z does not.
    w[k] = 1 / seen[order[k]].z;
  }

  // The long edge is the left one, or the two short ones are.
  auto [x_left, x_right] = interpolate_edges(y, x);
  auto [w_left, w_right] = interpolate_edges(y, w);
  const std::size_t middle = x_left.size() / 2;
  if (x_left[middle] >= x_right[middle]) {
    std::swap(x_left, x_right);
    std::swap(w_left, w_right);
  }

  for (double row = y[0]; row <= y[2]; ++row) {
    PS_REACHING("row", row);
    const double left = std::trunc(entry(x_left, row, y[0]));
    const double right = std::trunc(entry(x_right, row, y[0]));
    PS_WATCH("left, right", Vec2d(left, right));
    const double w_l = entry(w_left, row, y[0]);
    const double w_r = entry(w_right, row, y[0]);
    const auto w_row = interpolate(left, w_l, right, w_r);
    for (double column = left; column <= right; ++column) {
      PS_PIXEL(column, row);
      const double new_w = entry(w_row, column, left);
      PS_WATCH("1/z", new_w);
      PS_WATCH("z", 1 / new_w);
      bool visible = true;
      if (test_depth) visible = canvas.nearer(column, row, new_w);
      PS_WATCH("nearer than the stored depth", visible);
      if (visible) canvas.put_pixel(column, row, colour);
    }
  }
}

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

// The author's program shows the triangles by their edges, which
// do not ask for depth.
void draw_outline(BookCanvas& canvas, const Points& projected,
                  Vec3d colour) {
  const auto order = sorted_by_height(projected);
  const Vec2d low = projected[order[0]];
  const Vec2d middle = projected[order[1]];
  const Vec2d high = projected[order[2]];
  draw_line(canvas, low, middle, colour * 0.75);
  draw_line(canvas, low, high, colour * 0.75);
  draw_line(canvas, high, middle, colour * 0.75);
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const Settings& settings = scene.settings;
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Transform& t = instance.instance->transform;
    const Mat4d to_world = model_to_world(t);
    const Mat4d to_camera =
        world_to_camera(scene.camera) * to_world;
    const auto& positions = instance.model->positions;

    for (const MeshTriangle& face : instance.model->triangles) {
      PS_REACHING("triangle", instance.number_of(face));
      Corners seen;
      Points p;
      bool whole = true;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        seen[k] = transform(to_camera, positions[face.position[k]]);
        PS_WATCH("from the camera", seen[k]);
        p[k] = project(scene, seen[k]);
        PS_WATCH("on the canvas", p[k]);
        const bool far = canvas.far_outside(p[k]);
        whole = whole && seen[k].z > 0 && !far;
      }
      if (!whole) continue;
      if (settings.backface_culling && is_back_face(seen)) continue;
      const Vec3d colour = surface_of(scene, instance, face).colour;
      PS_WATCH("colour", colour);
      draw_triangle(scene, canvas, p, seen, colour);
      if (settings.draw == Draw::outlined)
        draw_outline(canvas, p, colour);
    }
  }
}

}  // namespace
}  // namespace cgfs_12_hidden_surfaces

namespace textbook {
extern const Listing cgfs_12_hidden_surfaces;
const Listing cgfs_12_hidden_surfaces{
    .label = "hidden surfaces",
    .source = "CGFS ch. 12",
    .shows = "Models in plain colours, with a depth buffer and "
             "without back faces.",
    .order = ListingOrder::object_by_object,
    .reads = {"visibility", "backface-culling", "draw"},
    .draws = {.models = true},
    .suits =
        [](const SceneTraits& traits, const Settings& settings) {
          if (!traits.triangles) return 0;
          return settings.lighting ? 2 : 5;
        },
    .draw = ps::cgfs_12_hidden_surfaces::draw,
};
}  // namespace textbook
}  // namespace ps
