#include <array>
#include <cmath>
#include <limits>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_14_textures {
namespace {

using Corners = std::array<Vec3d, 3>;
using Points = std::array<Vec2d, 3>;

// One triangle as the camera sees it, in camera space.
struct Seen {
  Corners vertex, normal;
  Points canvas, uv;
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

Vec3d read_texel(const Texture& texture, double column, double row,
                 bool demo_slips) {
  const int width = texture.texels->width();
  const int height = texture.texels->height();
  PS_WATCH("texel", Vec2d(column, row));
  if (!demo_slips) {
    column = std::min(std::max(column, 0.0), width - 1.0);
    row = std::min(std::max(row, 0.0), height - 1.0);
  }
  // The slip: at u = 1 this is the first texel of the next row, at
  // v = 1 there is none, and no number at all.
  const double index = row * width + column;
  const double texels = static_cast<double>(width) * height;
  const bool exists = index >= 0 && index < texels;
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  if (!exists) return Vec3d(nothing);
  return texel_of(texture, static_cast<std::size_t>(index));
}

// The nearest texel up and to the left, or the four around the
// place, by how near each of them is.
Vec3d read_texture(const Texture& texture, Vec2d uv,
                   const Settings& settings) {
  const bool slips = settings.demo_slips;
  const auto texel = [&](double column, double row) {
    return read_texel(texture, column, row, slips);
  };
  const double x = uv.x * texture.texels->width();
  const double y = uv.y * texture.texels->height();
  if (settings.texture_filter != TextureFilter::bilinear)
    return texel(std::trunc(x), std::trunc(y));

  // Texels lie at the centres of their squares. The demo's trunc()
  // goes towards 0, floor() to the left of it too.
  double column = std::floor(x - 0.5), row = std::floor(y - 0.5);
  if (slips)
    column = std::trunc(x - 0.5), row = std::trunc(y - 0.5);
  const double right = x - 0.5 - column;
  const double below = y - 0.5 - row;
  // The slip: the fourth texel is two rows below the first one, in
  // place of one below and to the right.
  Vec2d fourth(column + 1, row + 1);
  if (slips) fourth = {column, row + 2};

  const Vec3d a = texel(column, row);
  const Vec3d b = texel(column + 1, row);
  const Vec3d c = texel(column, row + 1);
  const Vec3d d = texel(fourth.x, fourth.y);
  const Vec3d upper = a * (1 - right) + b * right;
  const Vec3d lower = c * (1 - right) + d * right;
  return upper * (1 - below) + lower * below;
}

// sorted_by_height() and interpolate_edges() are the sort and the
// join of chapter 7.
void draw_triangle(const BookScene& scene, BookCanvas& canvas,
                   const Seen& seen) {
  const Settings& settings = scene.settings;
  const bool perspective =
      settings.interpolation == Interpolation::perspective;
  const BookSurface& surface = seen.surface;
  const auto order = sorted_by_height(seen.canvas);
  std::array<double, 3> x, y;
  // u/z, v/z and 1/z change evenly across the canvas; u and v do
  // not.
  Corners uvz, normal;
  for (std::size_t k = 0; k < 3; ++k) {
    PS_EACH("vertex, from below", k);
    x[k] = seen.canvas[order[k]].x;
    y[k] = seen.canvas[order[k]].y;
    normal[k] = seen.normal[order[k]];
    const double z = seen.vertex[order[k]].z;
    Vec2d uv = seen.uv[order[k]];
    if (perspective) uv = uv / z;
    uvz[k] = {uv.x, uv.y, 1 / z};
    PS_WATCH("u/z, v/z, 1/z", uvz[k]);
  }

  // The long edge is the left one, or the two short ones are.
  auto [x_left, x_right] = interpolate_edges(y, x);
  auto [uvz_left, uvz_right] = interpolate_edges(y, uvz);
  auto [n_left, n_right] = interpolate_edges(y, normal);
  const std::size_t middle = x_left.size() / 2;
  if (x_left[middle] >= x_right[middle]) {
    std::swap(x_left, x_right);
    std::swap(uvz_left, uvz_right);
    std::swap(n_left, n_right);
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
    const auto uvz_row = across(uvz_left, uvz_right);
    const auto n_row = across(n_left, n_right);

    for (double column = left; column <= right; ++column) {
      PS_PIXEL(column, row);
      const Vec3d here = entry(uvz_row, column, left);
      PS_WATCH("u/z, v/z, 1/z here", here);
      if (!canvas.nearer(column, row, here.z)) continue;

      const Vec3d n = entry(n_row, column, left);
      const Vec3d point = unproject(scene, column, row, here.z);
      PS_WATCH("point", point);
      const double intensity =
          compute_illumination(scene, point, n, surface.specular);
      PS_WATCH("intensity", intensity);

      Vec3d colour = surface.colour;
      if (surface.texture) {
        Vec2d uv(here.x, here.y);
        if (perspective) uv = uv / here.z;
        PS_WATCH("u, v", uv);
        colour = read_texture(*surface.texture, uv, settings);
      }
      PS_WATCH("local colour", colour);
      canvas.put_pixel(column, row, colour * intensity);
      PS_WATCH("colour", colour * intensity);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
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
        seen.canvas[k] = project(scene, v[k]);
        PS_WATCH("on the canvas", seen.canvas[k]);
        const bool far = canvas.far_outside(seen.canvas[k]);
        whole = whole && v[k].z > 0 && !far;
        seen.uv[k] = {0, 0};
        const auto index = static_cast<std::size_t>(face.uv[k]);
        if (face.uv[k] >= 0) seen.uv[k] = mesh.uvs[index];
        PS_WATCH("u, v of the vertex", seen.uv[k]);
      }
      if (!whole) continue;

      const Vec3d flat = cross(v[1] - v[0], v[2] - v[0]);
      if (dot(-v[0], flat) <= 0) continue;  // a back face
      for (std::size_t k = 0; k < 3; ++k) {
        seen.normal[k] = flat;
        if (face.normal[k] < 0) continue;
        const auto index = static_cast<std::size_t>(face.normal[k]);
        seen.normal[k] = turn(turn_normals, mesh.normals[index]);
      }
      seen.surface = surface_of(scene, instance, face);
      draw_triangle(scene, canvas, seen);
    }
  }
}

}  // namespace
}  // namespace cgfs_14_textures

namespace textbook {
extern const Listing cgfs_14_textures;
const Listing cgfs_14_textures{
    .label = "textures",
    .source = "CGFS ch. 14",
    .shows = "Lit and textured models, perspective-correct or not.",
    .order = ListingOrder::object_by_object,
    .reads = {"interpolation", "diffuse", "specular",
              "texture-filter", "demo-slips"},
    .draws = {.models = true, .light = true, .textures = true},
    .as_settings =
        [](Settings& settings) {
          settings.backface_culling = true;
          settings.visibility = Visibility::depth_buffer;
          settings.shading = Shading::phong;
          settings.normals = Normals::vertex;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          if (!traits.triangles) return 0;
          return traits.textures ? 4 : 1;
        },
    .draw = ps::cgfs_14_textures::draw,
};
}  // namespace textbook
}  // namespace ps
