// Nothing casts a shadow.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_15_shadows_in_the_rasterizer {
namespace {

using Triangle = std::array<Vec3d, 3>;  // in the world

// What a light with parallel rays sees of the models: the depth of the nearest surface for each texel.
struct ShadowMap {
  Vec3d right, up, forward;            // forward: the way that the light goes
  double left = 0, top = 0, side = 1;  // of the square around all models
  int size = 0;                        // texels along the side
  std::vector<double> depth;           // row by row from the top left, infinity where there is nothing

  // Column and row on the map, with their fractions, and the depth. No division by the depth: rays are parallel.
  Vec3d seen(const Vec3d& p) const {
    return {(dot(right, p) - left) * size / side, (top - dot(up, p)) * size / side, dot(forward, p)};
  }
  std::size_t texel(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
  }
};

using Maps = std::vector<ShadowMap>;  // one for each light

// Twice the area of the triangle a, b, p.
double edge(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

using Pixel = std::function<void(int, int, const Vec3d&)>;

// Calls pixel(x, y, weights of the vertices) for all whole x and y inside of a triangle, from `low` to below `high`.
void fill(std::array<Vec2d, 3> p, const Vec2i& low, const Vec2i& high, const Pixel& pixel) {
  for (Vec2d& each : p) each = {std::nearbyint(each.x * 256) / 256, std::nearbyint(each.y * 256) / 256};
  const double area = edge(p[0], p[1], p[2]);
  if (area == 0) return;
  const auto [x_low, x_high] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [y_low, y_high] = std::minmax({p[0].y, p[1].y, p[2].y});
  const int left = std::max(low.x, static_cast<int>(std::ceil(x_low)));
  const int right = std::min(high.x - 1, static_cast<int>(std::floor(x_high)));
  const int bottom = std::max(low.y, static_cast<int>(std::ceil(y_low)));
  const int top = std::min(high.y - 1, static_cast<int>(std::floor(y_high)));
  for (int y = bottom; y <= top; ++y) {
    for (int x = left; x <= right; ++x) {
      const Vec2d here(x, y);
      const Vec3d w = Vec3d(edge(p[1], p[2], here), edge(p[2], p[0], here), edge(p[0], p[1], here)) / area;
      if (w.x >= 0 && w.y >= 0 && w.z >= 0) pixel(x, y, w);
    }
  }
}

// A camera that looks along the light. The square holds all models, and a margin of two texels.
ShadowMap empty_map(const std::vector<Triangle>& triangles, const Light& light, int size) {
  ShadowMap map;
  map.size = size;
  map.depth.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                   std::numeric_limits<double>::infinity());
  map.forward = -light.direction / length(light.direction);
  const Vec3d across = cross(std::abs(map.forward.y) < 0.9 ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1), map.forward);
  map.right = across / length(across);
  map.up = cross(map.forward, map.right);
  Vec2d low(std::numeric_limits<double>::infinity()), high = -low;
  for (const Triangle& triangle : triangles) {
    for (const Vec3d& p : triangle) {
      const Vec2d seen(dot(map.right, p), dot(map.up, p));
      low = {std::min(low.x, seen.x), std::min(low.y, seen.y)};
      high = {std::max(high.x, seen.x), std::max(high.y, seen.y)};
    }
  }
  map.side = std::max({high.x - low.x, high.y - low.y, 1e-6}) * (1 + 4.0 / size);
  map.left = (low.x + high.x - map.side) / 2;
  map.top = (low.y + high.y + map.side) / 2;
  return map;
}

// The light's picture: a depth buffer, and no colours. A texel's depth is that at its centre.
ShadowMap draw_shadow_map(const std::vector<Triangle>& triangles, const Light& light, int size) {
  ShadowMap map = empty_map(triangles, light, size);
  for (const Triangle& triangle : triangles) {
    const Vec3d a = map.seen(triangle[0]), b = map.seen(triangle[1]), c = map.seen(triangle[2]);
    const Vec2d half(0.5, 0.5);
    fill({Vec2d(a) - half, Vec2d(b) - half, Vec2d(c) - half}, {0, 0}, {size, size},
         [&](int column, int row, const Vec3d& w) {
           const double depth = w.x * a.z + w.y * b.z + w.z * c.z;
           double& stored = map.depth[map.texel(column, row)];
           if (depth > stored) stored = depth;
         });
  }
  return map;
}

// How much nearer to the light a point is taken to be. A texel holds one depth for a patch of the surface: from its
// centre to its corner the depth grows by half a diagonal times the slope.
double bias_at(const ShadowMap& map, const Settings& settings, const Vec3d& normal) {
  const double slope = std::min(length(cross(normal, map.forward)) / std::abs(dot(normal, map.forward)), 100.0);
  double texels = settings.shadow_slope_bias;
  if (texels < 0) texels = std::sqrt(2.0) / 2 + 1 / 256.0;  // what is needed, and the rounding of vertices
  const double rounding = 1e-6;
  return settings.shadow_bias + texels * map.side / map.size * slope + rounding;
}

// Does the map hold something nearer to the light than the point?
bool in_shadow(const ShadowMap& map, const Settings& settings, const Vec3d& point, const Vec3d& normal) {
  const Vec3d seen = map.seen(point);
  PS_WATCH("column, row, depth", seen);
  const int column = static_cast<int>(std::floor(seen.x));
  const int row = static_cast<int>(std::floor(seen.y));
  if (column < 0 || row < 0 || column >= map.size || row >= map.size) return false;
  const double stored = map.depth[map.texel(column, row)];
  PS_WATCH("stored depth", stored);
  const double bias = bias_at(map, settings, normal);
  PS_WATCH("bias", bias);
  return stored < seen.z - bias;
}

// Chapter 3, without the lights that do not see the point p.
double compute_illumination(const BookScene& scene, const Maps& maps, const Vec3d& p, const Vec3d& n, double s) {
  double intensity = 0;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    PS_EACH("light", kind_name(light));
    if (light.kind == LightKind::ambient) {
      intensity += light.intensity;
      PS_WATCH("intensity so far", intensity);
      continue;
    }
    if (light.kind == LightKind::directional) {
      const bool shadow = in_shadow(maps[i], scene.settings, p, n);
      PS_WATCH("in shadow", shadow);
      if (shadow) continue;
    }
    const Vec3d to_light = light.kind == LightKind::point ? light.position - p : light.direction;
    PS_WATCH("to light", to_light);
    const double diffuse = dot(to_light, n) / length(to_light);
    PS_WATCH("cosine to the light", diffuse);
    if (diffuse > 0) intensity += diffuse * light.intensity;
    if (scene.settings.specular && s != -1) {
      const Vec3d reflected = n * (2 * dot(n, to_light)) - to_light;
      const Vec3d view = scene.camera.position - p;
      const double shine = dot(reflected, view) / (length(reflected) * length(view));
      PS_WATCH("cosine to the viewer", shine);
      if (shine > 0) intensity += power(shine, s) * light.intensity;
    }
    PS_WATCH("intensity so far", intensity);
  }
  return intensity;
}

Vec2d project(const BookScene& scene, const Vec3d& p) {
  const Camera& camera = scene.camera;
  return {p.x * camera.projection_plane_d / p.z * scene.width / camera.viewport_width,
          p.y * camera.projection_plane_d / p.z * scene.height / camera.viewport_height};
}

// The camera's picture. The point of a pixel is found from the world's vertices, for it is the light that asks.
void draw_triangle(const BookScene& scene, BookCanvas& canvas, const Maps& maps, const Triangle& world,
                   const Triangle& seen, const BookSurface& surface) {
  const Vec3d across = cross(world[1] - world[0], world[2] - world[0]), normal = across / length(across);
  fill({project(scene, seen[0]), project(scene, seen[1]), project(scene, seen[2])}, {canvas.left(), canvas.bottom()},
       {canvas.right(), canvas.top()}, [&](int x, int y, const Vec3d& w) {
         PS_PIXEL(x, y);
         const Vec3d by_z(w.x / seen[0].z, w.y / seen[1].z, w.z / seen[2].z);
         const double inverse_z = by_z.x + by_z.y + by_z.z;
         PS_WATCH("1/z", inverse_z);
         if (!canvas.nearer(x, y, inverse_z)) return;
         const Vec3d point = (world[0] * by_z.x + world[1] * by_z.y + world[2] * by_z.z) / inverse_z;
         PS_WATCH("point", point);
         const double intensity = compute_illumination(scene, maps, point, normal, surface.specular);
         PS_WATCH("intensity", intensity);
         canvas.put_pixel(x, y, surface.colour * intensity);
         PS_WATCH("colour", surface.colour * intensity);
       });
}

std::vector<Triangle> world_triangles(const BookInstance& instance) {
  const Transform& t = instance.instance->transform;
  const Mat4d place = translation_matrix(t.translation) * (rotation_matrix(t.rotation) * scale_matrix(t.scale));
  std::vector<Triangle> all;
  for (const MeshTriangle& triangle : instance.model->triangles) {
    const auto vertex = [&](std::size_t k) {
      return transform(place, instance.model->positions[triangle.position[k]]);
    };
    all.push_back({vertex(0), vertex(1), vertex(2)});
  }
  return all;
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  // First what each light sees of all models, then what the camera sees.
  std::vector<Triangle> all;
  for (const BookInstance& instance : scene.instances)
    for (const Triangle& triangle : world_triangles(instance)) all.push_back(triangle);
  Maps maps(scene.lights.size());
  for (std::size_t i = 0; i < maps.size(); ++i)
    if (scene.lights[i].kind == LightKind::directional)
      maps[i] = draw_shadow_map(all, scene.lights[i], scene.settings.shadow_map_size);

  const Mat4d to_camera = camera_rotation_inverse(scene.camera) * translation_matrix(-scene.camera.position);
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const std::vector<Triangle> world = world_triangles(instance);
    for (std::size_t i = 0; i < world.size(); ++i) {
      const MeshTriangle& triangle = instance.model->triangles[i];
      PS_REACHING("triangle", instance.number_of(triangle));
      Triangle seen;
      bool whole = true;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        seen[k] = transform(to_camera, world[i][k]);
        PS_WATCH("from the camera", seen[k]);
        PS_WATCH("on the canvas", project(scene, seen[k]));
        whole = whole && seen[k].z > 0 && !canvas.far_outside(project(scene, seen[k]));
      }
      const bool front = dot(-seen[0], cross(seen[1] - seen[0], seen[2] - seen[0])) > 0;
      if (whole && front) draw_triangle(scene, canvas, maps, world[i], seen, surface_of(scene, instance, triangle));
    }
  }
}

}  // namespace
}  // namespace cgfs_15_shadows_in_the_rasterizer

namespace textbook {
extern const Listing cgfs_15_shadows_in_the_rasterizer;
const Listing cgfs_15_shadows_in_the_rasterizer{
    .label = "shadow map",
    .source = "CGFS ch. 15",
    .shows = "Lit models with the shadows of directional lights, from a shadow map for each. Point lights cast none.",
    .order = ListingOrder::object_by_object,
    .reads = {"shadow-map-size", "shadow-bias", "shadow-slope-bias", "specular"},
    .draws = {.models = true, .light = true, .shadows = true},
    .as_settings =
        [](Settings& settings) {
          settings.backface_culling = true;
          settings.visibility = Visibility::depth_buffer;
          settings.interpolation = Interpolation::perspective;
          settings.shading = Shading::phong;
          settings.normals = Normals::triangle;
          settings.shadows = Shadows::map;
          settings.shadow_filter = 1;
          settings.subpixel_bits = 8;
        },
    .suits = [](const SceneTraits& traits,
                const Settings& settings) { return !traits.triangles                  ? 0
                                                   : settings.shadows == Shadows::map ? 6
                                                                                      : 1; },
    .draw = ps::cgfs_15_shadows_in_the_rasterizer::draw,
};
}  // namespace textbook
}  // namespace ps
