#include <array>
#include <cmath>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_13_shading {
namespace {

// One triangle as the camera sees it.
struct Seen {
  std::array<Vec3d, 3> vertex;  // camera space
  std::array<Vec3d, 3> normal;  // camera space
  std::array<Vec2d, 3> canvas;
  BookSurface surface;
};

Vec2d project(const BookScene& scene, const Vec3d& p) {
  const Camera& camera = scene.camera;
  const double x = p.x * camera.projection_plane_d / p.z * scene.width / camera.viewport_width;
  const double y = p.y * camera.projection_plane_d / p.z * scene.height / camera.viewport_height;
  return {std::trunc(x), std::trunc(y)};
}

// The way back: the point of camera space that is at a place of the canvas, at this 1/z.
Vec3d unproject(const BookScene& scene, double x, double y, double inverse_z) {
  const Camera& camera = scene.camera;
  const double z = 1 / inverse_z;
  return {x * z / camera.projection_plane_d * camera.viewport_width / scene.width,
          y * z / camera.projection_plane_d * camera.viewport_height / scene.height, z};
}

// Everything here is in camera space.
double compute_illumination(const BookScene& scene, const Vec3d& point, const Vec3d& normal, double specular) {
  const Mat4d turned = camera_rotation_inverse(scene.camera);
  const Mat4d to_camera = turned * translation_matrix(-scene.camera.position);
  double intensity = 0;
  for (const Light& light : scene.lights) {
    PS_EACH("light", kind_name(light));
    if (light.kind == LightKind::ambient) {
      intensity += light.intensity;
      PS_WATCH("intensity so far", intensity);
      continue;
    }
    Vec3d to_light = turn(turned, light.direction);
    if (light.kind == LightKind::point) to_light = transform(to_camera, light.position) - point;
    PS_WATCH("to light", to_light);

    const double diffuse = dot(to_light, normal) / (length(to_light) * length(normal));
    PS_WATCH("cosine to the light", diffuse);
    if (scene.settings.diffuse && diffuse > 0) intensity += diffuse * light.intensity;
    PS_WATCH("with diffuse", intensity);

    if (scene.settings.specular && specular != -1) {
      const Vec3d reflected = normal * (2 * dot(normal, to_light)) - to_light;
      const Vec3d right_view = -point;  // the camera is at the origin of its own space
      // The slip of the author's program: a place in the world less a point of camera space.
      // It is right only for a camera at the world's origin; elsewhere highlights move.
      const Vec3d mixed_view = scene.camera.position - point;
      const Vec3d view = scene.settings.demo_slips ? mixed_view : right_view;
      PS_WATCH("view as the demo has it", mixed_view);
      PS_WATCH("view as it should be", right_view);
      const double shine = dot(reflected, view) / (length(reflected) * length(view));
      PS_WATCH("cosine to the viewer", shine);
      if (shine > 0) intensity += power(shine, specular) * light.intensity;
    }
    PS_WATCH("intensity so far", intensity);
  }
  return intensity;
}

// sorted_by_height() and interpolate_edges() are the sort and the join of chapter 7.
void draw_triangle(const BookScene& scene, BookCanvas& canvas, const Seen& seen) {
  const auto order = sorted_by_height(seen.canvas);
  std::array<double, 3> y, columns, inverse_z;
  for (std::size_t k = 0; k < 3; ++k) {
    columns[k] = seen.canvas[order[k]].x;
    y[k] = seen.canvas[order[k]].y;
    inverse_z[k] = 1 / seen.vertex[order[k]].z;
  }

  // What is interpolated: nothing, the intensity at the vertices (as x), or the normal.
  std::array<Vec3d, 3> at_vertex{};
  const Shading shading = scene.settings.shading;
  if (shading == Shading::flat) {
    const Vec3d middle = (seen.vertex[0] + seen.vertex[1] + seen.vertex[2]) / 3.0;
    const double all = compute_illumination(scene, middle, seen.normal[order[0]], seen.surface.specular);
    PS_WATCH("intensity of the whole triangle", all);
    at_vertex.fill({all, 0, 0});
  } else {
    for (std::size_t k = 0; k < 3; ++k) {
      at_vertex[k] = seen.normal[order[k]];
      if (shading == Shading::phong) continue;
      PS_EACH("vertex, from below", k);
      const double own = compute_illumination(scene, seen.vertex[order[k]], at_vertex[k], seen.surface.specular);
      PS_WATCH("intensity at the vertex", own);
      at_vertex[k] = {own, 0, 0};
    }
  }

  const auto x = interpolate_edges<double>(y, columns);
  const auto z = interpolate_edges<double>(y, inverse_z);
  const auto edges = interpolate_edges<Vec3d>(y, at_vertex);
  const std::size_t middle = x.long_edge.size() / 2;
  const bool long_is_left = x.long_edge[middle] < x.short_edges[middle];

  for (double row = y[0]; row <= y[2]; ++row) {
    PS_REACHING("row", row);
    const double a = std::trunc(entry(x.long_edge, row, y[0])), b = std::trunc(entry(x.short_edges, row, y[0]));
    const double z_a = entry(z.long_edge, row, y[0]), z_b = entry(z.short_edges, row, y[0]);
    const Vec3d value_a = entry(edges.long_edge, row, y[0]), value_b = entry(edges.short_edges, row, y[0]);
    const double left = long_is_left ? a : b, right = long_is_left ? b : a;
    PS_WATCH("left, right", Vec2d(left, right));
    const auto z_row = long_is_left ? interpolate(left, z_a, right, z_b) : interpolate(left, z_b, right, z_a);
    const auto value_row =
        long_is_left ? interpolate(left, value_a, right, value_b) : interpolate(left, value_b, right, value_a);
    for (double column = left; column <= right; ++column) {
      PS_PIXEL(column, row);
      const double new_z = entry(z_row, column, left);
      PS_WATCH("1/z", new_z);
      if (!canvas.nearer(column, row, new_z)) continue;
      const Vec3d value = entry(value_row, column, left);
      double intensity = value.x;
      if (shading == Shading::phong) {
        PS_WATCH("normal", value);
        const Vec3d point = unproject(scene, column, row, new_z);
        PS_WATCH("point", point);
        intensity = compute_illumination(scene, point, value, seen.surface.specular);
      }
      PS_WATCH("intensity", intensity);
      const Vec3d colour = seen.surface.colour * intensity;
      PS_WATCH("colour", colour);
      canvas.put_pixel(column, row, colour);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Transform& t = instance.instance->transform;
    const Mat4d model = translation_matrix(t.translation) * (rotation_matrix(t.rotation) * scale_matrix(t.scale));
    const Mat4d turned = camera_rotation_inverse(scene.camera);
    const Mat4d to_camera = turned * translation_matrix(-scene.camera.position) * model;
    const Mat4d normal_to_camera = turned * rotation_matrix(t.rotation);
    const Mesh& mesh = *instance.model;

    for (const MeshTriangle& triangle : mesh.triangles) {
      PS_REACHING("triangle", instance.number_of(triangle));
      Seen seen;
      bool whole = true;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        seen.vertex[k] = transform(to_camera, mesh.positions[triangle.position[k]]);
        PS_WATCH("from the camera", seen.vertex[k]);
        seen.canvas[k] = project(scene, seen.vertex[k]);
        PS_WATCH("on the canvas", seen.canvas[k]);
        whole = whole && seen.vertex[k].z > 0 && !canvas.far_outside(seen.canvas[k]);
      }
      if (!whole) continue;

      const Vec3d flat_normal = cross(seen.vertex[1] - seen.vertex[0], seen.vertex[2] - seen.vertex[0]);
      if (!(dot(-seen.vertex[0], flat_normal) > 0)) continue;  // a back face
      for (std::size_t k = 0; k < 3; ++k) {
        const bool of_vertex = scene.settings.normals == Normals::vertex && triangle.normal[k] >= 0;
        seen.normal[k] = of_vertex ? turn(normal_to_camera, mesh.normals[static_cast<std::size_t>(triangle.normal[k])])
                                   : flat_normal;
      }
      seen.surface = surface_of(scene, instance, triangle);
      draw_triangle(scene, canvas, seen);
    }
  }
}

}  // namespace
}  // namespace cgfs_13_shading

namespace textbook {
extern const Listing cgfs_13_shading;
const Listing cgfs_13_shading{
    .label = "shading",
    .source = "CGFS ch. 13",
    .shows = "Lit models: one intensity for a triangle, for each vertex, or for each pixel.",
    .order = ListingOrder::object_by_object,
    .reads = {"shading", "normals", "diffuse", "specular", "demo-slips"},
    .draws = {.models = true, .light = true},
    .as_settings =
        [](Settings& settings) {
          settings.backface_culling = true;
          settings.visibility = Visibility::depth_buffer;
          settings.interpolation = Interpolation::affine;
        },
    .suits = [](const SceneTraits& traits, const Settings&) { return traits.triangles ? 3 : 0; },
    .draw = ps::cgfs_13_shading::draw,
};
}  // namespace textbook
}  // namespace ps
