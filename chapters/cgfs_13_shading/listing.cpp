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

using Corners = std::array<Vec3d, 3>;
using Points = std::array<Vec2d, 3>;

// One triangle as the camera sees it, in camera space.
struct Seen {
  Corners vertex, normal;
  Points canvas;
  BookSurface surface;
};

Vec2d project(const BookScene& scene, const Vec3d& p) {
  const double d = scene.camera.projection_plane_d;
  const double vw = scene.camera.viewport_width;
  const double vh = scene.camera.viewport_height;
  const double x = p.x * d / p.z * scene.width / vw;
  const double y = p.y * d / p.z * scene.height / vh;
  return {std::trunc(x), std::trunc(y)};
}

// The way back: the point of camera space that is at a place of the
// canvas, at this 1/z.
Vec3d unproject(const BookScene& scene, double x, double y,
                double inverse_z) {
  const Camera& camera = scene.camera;
  const double d = camera.projection_plane_d;
  const double z = 1 / inverse_z;
  const double across = x * z / d * camera.viewport_width;
  const double upwards = y * z / d * camera.viewport_height;
  return {across / scene.width, upwards / scene.height, z};
}

// From a point to the camera, which is at the origin of its own
// space. The author's program takes a place in the world minus the
// point, a slip: elsewhere than at the world's origin highlights
// move.
Vec3d to_viewer(const BookScene& scene, const Vec3d& point) {
  const Vec3d slip = scene.camera.position - point;
  const Vec3d right = -point;
  PS_WATCH("view as the demo has it", slip);
  PS_WATCH("view as it should be", right);
  return scene.settings.demo_slips ? slip : right;
}

// Everything here is in camera space.
double compute_illumination(const BookScene& scene, Vec3d point,
                            Vec3d normal, double specular) {
  const Settings& settings = scene.settings;
  const Mat4d to_camera = world_to_camera(scene.camera);
  double intensity = 0;
  for (const Light& light : scene.lights) {
    PS_EACH("light", kind_name(light));
    if (light.kind == LightKind::ambient) {
      intensity += light.intensity;
      PS_WATCH("intensity so far", intensity);
      continue;
    }
    Vec3d to_light = turn(to_camera, light.direction);
    if (light.kind == LightKind::point)
      to_light = transform(to_camera, light.position) - point;
    PS_WATCH("to light", to_light);

    const double n_dot_l = dot(normal, to_light);
    const double lengths = length(to_light) * length(normal);
    const double diffuse = n_dot_l / lengths;
    PS_WATCH("cosine to the light", diffuse);
    if (settings.diffuse && diffuse > 0)
      intensity += diffuse * light.intensity;
    PS_WATCH("with diffuse", intensity);

    if (settings.specular && specular != -1) {
      const Vec3d reflected = normal * (2 * n_dot_l) - to_light;
      const Vec3d view = to_viewer(scene, point);
      const double sizes = length(reflected) * length(view);
      const double shine = dot(reflected, view) / sizes;
      PS_WATCH("cosine to the viewer", shine);
      if (shine > 0)
        intensity += power(shine, specular) * light.intensity;
    }
    PS_WATCH("intensity so far", intensity);
  }
  return intensity;
}

// The intensities at the vertices: one for all of them, or one for
// each. Phong shading has none yet.
std::array<double, 3> illuminate(const BookScene& scene,
                                 const Corners& vertex,
                                 const Corners& normal,
                                 double specular) {
  std::array<double, 3> light{};
  const Shading shading = scene.settings.shading;
  if (shading == Shading::flat) {
    const Vec3d middle = (vertex[0] + vertex[1] + vertex[2]) / 3.0;
    const double all =
        compute_illumination(scene, middle, normal[0], specular);
    PS_WATCH("intensity of the whole triangle", all);
    light.fill(all);
  }
  if (shading == Shading::gouraud) {
    for (std::size_t k = 0; k < 3; ++k) {
      PS_EACH("vertex, from below", k);
      light[k] = compute_illumination(scene, vertex[k], normal[k],
                                      specular);
      PS_WATCH("intensity at the vertex", light[k]);
    }
  }
  return light;
}

// sorted_by_height() and interpolate_edges() are the sort and the
// join of chapter 7.
void draw_triangle(const BookScene& scene, BookCanvas& canvas,
                   const Seen& seen) {
  const double specular = seen.surface.specular;
  const auto order = sorted_by_height(seen.canvas);
  std::array<double, 3> x, y, inverse_z;
  Corners vertex, normal;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = seen.canvas[order[k]].x;
    y[k] = seen.canvas[order[k]].y;
    vertex[k] = seen.vertex[order[k]];
    normal[k] = seen.normal[order[k]];
    inverse_z[k] = 1 / vertex[k].z;
  }
  const auto light = illuminate(scene, vertex, normal, specular);

  // The long edge is the left one, or the two short ones are.
  auto [x_left, x_right] = interpolate_edges(y, x);
  auto [z_left, z_right] = interpolate_edges(y, inverse_z);
  auto [n_left, n_right] = interpolate_edges(y, normal);
  auto [light_left, light_right] = interpolate_edges(y, light);
  const std::size_t middle = x_left.size() / 2;
  if (x_left[middle] >= x_right[middle]) {
    std::swap(x_left, x_right);
    std::swap(z_left, z_right);
    std::swap(n_left, n_right);
    std::swap(light_left, light_right);
  }

  for (double row = y[0]; row <= y[2]; ++row) {
    PS_REACHING("row", row);
    const auto on_row = [&](const auto& edge) {
      return entry(edge, row, y[0]);
    };
    const double left = std::trunc(on_row(x_left));
    const double right = std::trunc(on_row(x_right));
    PS_WATCH("left, right", Vec2d(left, right));
    const auto across = [&](const auto& from, const auto& to) {
      return interpolate(left, on_row(from), right, on_row(to));
    };
    const auto z_row = across(z_left, z_right);
    const auto n_row = across(n_left, n_right);
    const auto light_row = across(light_left, light_right);

    for (double column = left; column <= right; ++column) {
      PS_PIXEL(column, row);
      const double new_z = entry(z_row, column, left);
      PS_WATCH("1/z", new_z);
      if (!canvas.nearer(column, row, new_z)) continue;
      double intensity = entry(light_row, column, left);
      if (scene.settings.shading == Shading::phong) {
        const Vec3d n = entry(n_row, column, left);
        PS_WATCH("normal", n);
        const Vec3d point = unproject(scene, column, row, new_z);
        PS_WATCH("point", point);
        intensity = compute_illumination(scene, point, n, specular);
      }
      PS_WATCH("intensity", intensity);
      const Vec3d colour = seen.surface.colour * intensity;
      PS_WATCH("colour", colour);
      canvas.put_pixel(column, row, colour);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const Normals normals = scene.settings.normals;
  const bool own = normals == Normals::vertex;
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Transform& t = instance.instance->transform;
    const Mat4d to_world = model_to_world(t);
    const Mat4d to_camera =
        world_to_camera(scene.camera) * to_world;
    const Mat4d rotate = rotation_matrix(t.rotation);
    const Mat4d rotate_back = camera_rotation_inverse(scene.camera);
    const Mat4d turn_normals = rotate_back * rotate;
    const Mesh& mesh = *instance.model;

    for (const MeshTriangle& face : mesh.triangles) {
      PS_REACHING("triangle", instance.number_of(face));
      Seen seen;
      Corners& v = seen.vertex;
      bool whole = true;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        v[k] =
            transform(to_camera, mesh.positions[face.position[k]]);
        PS_WATCH("from the camera", v[k]);
        seen.canvas[k] = project(scene, v[k]);
        PS_WATCH("on the canvas", seen.canvas[k]);
        const bool far = canvas.far_outside(seen.canvas[k]);
        whole = whole && v[k].z > 0 && !far;
      }
      if (!whole) continue;

      const Vec3d flat = cross(v[1] - v[0], v[2] - v[0]);
      if (dot(-v[0], flat) <= 0) continue;  // a back face
      for (std::size_t k = 0; k < 3; ++k) {
        seen.normal[k] = flat;
        if (!own || face.normal[k] < 0) continue;
        const auto index = static_cast<std::size_t>(face.normal[k]);
        seen.normal[k] = turn(turn_normals, mesh.normals[index]);
      }
      seen.surface = surface_of(scene, instance, face);
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
    .shows = "Lit models: one intensity for a triangle, for each "
             "vertex, or for each pixel.",
    .order = ListingOrder::object_by_object,
    .reads = {"shading", "normals", "diffuse", "specular",
              "demo-slips"},
    .draws = {.models = true, .light = true},
    .as_settings =
        [](Settings& settings) {
          settings.backface_culling = true;
          settings.visibility = Visibility::depth_buffer;
          settings.interpolation = Interpolation::affine;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.triangles ? 3 : 0;
        },
    .draw = ps::cgfs_13_shading::draw,
};
}  // namespace textbook
}  // namespace ps
