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

Mat4d model_to_camera(const BookScene& scene, const Transform& t) {
  const Mat4d model = translation_matrix(t.translation) * (rotation_matrix(t.rotation) * scale_matrix(t.scale));
  return camera_rotation_inverse(scene.camera) * translation_matrix(-scene.camera.position) * model;
}

Vec2d project(const BookScene& scene, const Vec3d& p) {
  const Camera& camera = scene.camera;
  const double x = p.x * camera.projection_plane_d / p.z * scene.width / camera.viewport_width;
  const double y = p.y * camera.projection_plane_d / p.z * scene.height / camera.viewport_height;
  return {std::trunc(x), std::trunc(y)};
}

// A back face turns its normal away from the camera, which is at the origin.
bool is_back_face(const std::array<Vec3d, 3>& seen) {
  const Vec3d normal = cross(seen[1] - seen[0], seen[2] - seen[0]);
  const double facing = dot(-seen[0], normal);
  PS_WATCH("to the camera . normal", facing);
  return !(facing > 0);
}

// sorted_by_height() and interpolate_edges() are the sort and the join of chapter 7.
void draw_triangle(const BookScene& scene, BookCanvas& canvas, const std::array<Vec2d, 3>& projected,
                   const std::array<Vec3d, 3>& seen, const Vec3d& colour) {
  const auto order = sorted_by_height(projected);
  const std::array<Vec2d, 3> p{projected[order[0]], projected[order[1]], projected[order[2]]};
  const std::array<double, 3> y{p[0].y, p[1].y, p[2].y};

  // 1/z changes evenly across the canvas, z does not.
  const auto x = interpolate_edges<double>(y, {p[0].x, p[1].x, p[2].x});
  const auto inverse_z =
      interpolate_edges<double>(y, {1 / seen[order[0]].z, 1 / seen[order[1]].z, 1 / seen[order[2]].z});
  const std::size_t middle = x.long_edge.size() / 2;
  const bool long_is_left = x.long_edge[middle] < x.short_edges[middle];

  for (double row = y[0]; row <= y[2]; ++row) {
    PS_REACHING("row", row);
    const double a = std::trunc(entry(x.long_edge, row, y[0])), b = std::trunc(entry(x.short_edges, row, y[0]));
    const double z_a = entry(inverse_z.long_edge, row, y[0]), z_b = entry(inverse_z.short_edges, row, y[0]);
    const double left = long_is_left ? a : b, right = long_is_left ? b : a;
    PS_WATCH("left, right", Vec2d(left, right));
    const auto z = long_is_left ? interpolate(left, z_a, right, z_b) : interpolate(left, z_b, right, z_a);
    for (double column = left; column <= right; ++column) {
      PS_PIXEL(column, row);
      const double new_z = entry(z, column, left);
      PS_WATCH("1/z", new_z);
      PS_WATCH("z", 1 / new_z);
      const bool depth_buffer = scene.settings.visibility == Visibility::depth_buffer;
      const bool visible = !depth_buffer || canvas.nearer(column, row, new_z);
      PS_WATCH("nearer than the stored depth", visible);
      if (visible) canvas.put_pixel(column, row, colour);
    }
  }
}

// The line of chapter 6.
void draw_line(BookCanvas& canvas, Vec2d p0, Vec2d p1, const Vec3d& colour) {
  const bool along_x = std::abs(p1.x - p0.x) > std::abs(p1.y - p0.y);
  if (along_x ? p1.x < p0.x : p1.y < p0.y) std::swap(p0, p1);
  const double first = along_x ? p0.x : p0.y, last = along_x ? p1.x : p1.y;
  const auto others = along_x ? interpolate(first, p0.y, last, p1.y) : interpolate(first, p0.x, last, p1.x);
  for (double step = first; step <= last; ++step) {
    const double other = entry(others, step, first);
    const Vec2d place = along_x ? Vec2d(step, other) : Vec2d(other, step);
    PS_PIXEL(place.x, place.y);
    PS_WATCH("place", place);
    canvas.put_pixel(place.x, place.y, colour);
    PS_WATCH("colour", colour);
  }
}

// The author's program shows the triangles by their edges, which do not ask for depth.
void draw_outline(BookCanvas& canvas, const std::array<Vec2d, 3>& projected, const Vec3d& colour) {
  const auto order = sorted_by_height(projected);
  for (const auto& [from, to] : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {2, 1}})
    draw_line(canvas, projected[order[from]], projected[order[to]], colour * 0.75);
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Mat4d to_camera = model_to_camera(scene, instance.instance->transform);
    for (const MeshTriangle& triangle : instance.model->triangles) {
      PS_REACHING("triangle", instance.number_of(triangle));
      std::array<Vec3d, 3> seen;
      std::array<Vec2d, 3> p;
      bool whole = true;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        seen[k] = transform(to_camera, instance.model->positions[triangle.position[k]]);
        PS_WATCH("from the camera", seen[k]);
        p[k] = project(scene, seen[k]);
        PS_WATCH("on the canvas", p[k]);
        whole = whole && seen[k].z > 0 && !canvas.far_outside(p[k]);
      }
      if (!whole) continue;
      if (scene.settings.backface_culling && is_back_face(seen)) continue;
      const Vec3d colour = surface_of(scene, instance, triangle).colour;
      PS_WATCH("colour", colour);
      draw_triangle(scene, canvas, p, seen, colour);
      if (scene.settings.draw == Draw::outlined) draw_outline(canvas, p, colour);
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
    .shows = "Models in plain colours, with a depth buffer and without back faces.",
    .order = ListingOrder::object_by_object,
    .reads = {"visibility", "backface-culling", "draw"},
    .draws = {.models = true},
    .suits = [](const SceneTraits& traits,
                const Settings& settings) { return !traits.triangles   ? 0
                                                   : settings.lighting ? 2
                                                                       : 5; },
    .draw = ps::cgfs_12_hidden_surfaces::draw,
};
}  // namespace textbook
}  // namespace ps
