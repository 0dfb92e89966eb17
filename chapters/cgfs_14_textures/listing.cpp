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

// One triangle as the camera sees it.
struct Seen {
  std::array<Vec3d, 3> vertex;  // camera space
  std::array<Vec3d, 3> normal;  // camera space
  std::array<Vec2d, 3> canvas, uv;
  BookSurface surface;
};

Vec2d project(const BookScene& scene, const Vec3d& p) {
  const Camera& camera = scene.camera;
  const double x = p.x * camera.projection_plane_d / p.z * scene.width / camera.viewport_width;
  const double y = p.y * camera.projection_plane_d / p.z * scene.height / camera.viewport_height;
  return {std::trunc(x), std::trunc(y)};
}

Vec3d unproject(const BookScene& scene, double x, double y, double inverse_z) {
  const Camera& camera = scene.camera;
  const double z = 1 / inverse_z;
  return {x * z / camera.projection_plane_d * camera.viewport_width / scene.width,
          y * z / camera.projection_plane_d * camera.viewport_height / scene.height, z};
}

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

Vec3d read_texel(const Texture& texture, double column, double row, bool demo_slips) {
  const int width = texture.texels->width(), height = texture.texels->height();
  PS_WATCH("texel", Vec2d(column, row));
  if (!demo_slips) {
    column = std::min(std::max(column, 0.0), width - 1.0);
    row = std::min(std::max(row, 0.0), height - 1.0);
  }
  // The slip: at u = 1 this is the first texel of the next row, at v = 1 there is none, and no number at all.
  const double index = row * width + column;
  if (!(index >= 0 && index < static_cast<double>(width) * height))
    return Vec3d(std::numeric_limits<double>::quiet_NaN());
  return texel_of(texture, static_cast<std::size_t>(index));
}

// The nearest texel up and to the left, or the four around the place, by how near each of them is.
Vec3d read_texture(const Texture& texture, const Vec2d& uv, const Settings& settings) {
  const bool slips = settings.demo_slips;
  const double x = uv.x * texture.texels->width(), y = uv.y * texture.texels->height();
  if (settings.texture_filter != TextureFilter::bilinear)
    return read_texel(texture, std::trunc(x), std::trunc(y), slips);
  // Texels lie at the centres of their squares. The demo's trunc() goes towards 0, floor() to the left of it too.
  const double column = slips ? std::trunc(x - 0.5) : std::floor(x - 0.5);
  const double row = slips ? std::trunc(y - 0.5) : std::floor(y - 0.5);
  const double right = x - 0.5 - column, below = y - 0.5 - row;
  // The slip: the fourth texel is two rows below the first one, in place of one below and to the right.
  const Vec2d fourth = slips ? Vec2d(column, row + 2) : Vec2d(column + 1, row + 1);
  const Vec3d upper =
      read_texel(texture, column, row, slips) * (1 - right) + read_texel(texture, column + 1, row, slips) * right;
  const Vec3d lower = read_texel(texture, column, row + 1, slips) * (1 - right) +
                      read_texel(texture, fourth.x, fourth.y, slips) * right;
  return upper * (1 - below) + lower * below;
}

// sorted_by_height() and interpolate_edges() are the sort and the join of chapter 7.
void draw_triangle(const BookScene& scene, BookCanvas& canvas, const Seen& seen) {
  const auto order = sorted_by_height(seen.canvas);
  const bool perspective = scene.settings.interpolation == Interpolation::perspective;
  std::array<double, 3> y, columns;
  std::array<Vec3d, 3> uvz, normals;  // u/z, v/z and 1/z change evenly across the canvas; u and v do not
  for (std::size_t k = 0; k < 3; ++k) {
    PS_EACH("vertex, from below", k);
    columns[k] = seen.canvas[order[k]].x;
    y[k] = seen.canvas[order[k]].y;
    const Vec2d uv = seen.uv[order[k]];
    const double z = perspective ? seen.vertex[order[k]].z : 1;
    uvz[k] = {uv.x / z, uv.y / z, 1 / seen.vertex[order[k]].z};
    PS_WATCH("u/z, v/z, 1/z", uvz[k]);
    normals[k] = seen.normal[order[k]];
  }
  const auto x = interpolate_edges<double>(y, columns);
  const auto uvz_edges = interpolate_edges<Vec3d>(y, uvz);
  const auto normal_edges = interpolate_edges<Vec3d>(y, normals);
  const std::size_t middle = x.long_edge.size() / 2;
  const bool long_is_left = x.long_edge[middle] < x.short_edges[middle];

  for (double row = y[0]; row <= y[2]; ++row) {
    PS_REACHING("row", row);
    const double a = std::trunc(entry(x.long_edge, row, y[0])), b = std::trunc(entry(x.short_edges, row, y[0]));
    const Vec3d uvz_a = entry(uvz_edges.long_edge, row, y[0]), uvz_b = entry(uvz_edges.short_edges, row, y[0]);
    const Vec3d n_a = entry(normal_edges.long_edge, row, y[0]), n_b = entry(normal_edges.short_edges, row, y[0]);
    const double left = long_is_left ? a : b, right = long_is_left ? b : a;
    PS_WATCH("left, right", Vec2d(left, right));
    const auto uvz_row = long_is_left ? interpolate(left, uvz_a, right, uvz_b) : interpolate(left, uvz_b, right, uvz_a);
    const auto normal_row = long_is_left ? interpolate(left, n_a, right, n_b) : interpolate(left, n_b, right, n_a);
    for (double column = left; column <= right; ++column) {
      PS_PIXEL(column, row);
      const Vec3d here = entry(uvz_row, column, left);
      PS_WATCH("u/z, v/z, 1/z here", here);
      if (!canvas.nearer(column, row, here.z)) continue;

      const Vec3d normal = entry(normal_row, column, left);
      const Vec3d point = unproject(scene, column, row, here.z);
      PS_WATCH("point", point);
      const double intensity = compute_illumination(scene, point, normal, seen.surface.specular);
      PS_WATCH("intensity", intensity);

      Vec3d colour = seen.surface.colour;
      if (seen.surface.texture) {
        const Vec2d uv = perspective ? Vec2d(here.x / here.z, here.y / here.z) : Vec2d(here.x, here.y);
        PS_WATCH("u, v", uv);
        colour = read_texture(*seen.surface.texture, uv, scene.settings);
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
        seen.canvas[k] = project(scene, seen.vertex[k]);
        PS_WATCH("on the canvas", seen.canvas[k]);
        whole = whole && seen.vertex[k].z > 0 && !canvas.far_outside(seen.canvas[k]);
        seen.uv[k] = triangle.uv[k] >= 0 ? mesh.uvs[static_cast<std::size_t>(triangle.uv[k])] : Vec2d(0, 0);
        PS_WATCH("u, v of the vertex", seen.uv[k]);
      }
      if (!whole) continue;
      const Vec3d flat_normal = cross(seen.vertex[1] - seen.vertex[0], seen.vertex[2] - seen.vertex[0]);
      if (!(dot(-seen.vertex[0], flat_normal) > 0)) continue;  // a back face
      for (std::size_t k = 0; k < 3; ++k)
        seen.normal[k] = triangle.normal[k] >= 0
                             ? turn(normal_to_camera, mesh.normals[static_cast<std::size_t>(triangle.normal[k])])
                             : flat_normal;
      seen.surface = surface_of(scene, instance, triangle);
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
    .reads = {"interpolation", "diffuse", "specular", "texture-filter", "demo-slips"},
    .draws = {.models = true, .light = true, .textures = true},
    .as_settings =
        [](Settings& settings) {
          settings.backface_culling = true;
          settings.visibility = Visibility::depth_buffer;
          settings.shading = Shading::phong;
          settings.normals = Normals::vertex;
        },
    .suits = [](const SceneTraits& traits, const Settings&) { return !traits.triangles ? 0
                                                                     : traits.textures ? 4
                                                                                       : 1; },
    .draw = ps::cgfs_14_textures::draw,
};
}  // namespace textbook
}  // namespace ps
