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
using Triangles = std::vector<Triangle>;
using Points = std::array<Vec2d, 3>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// What a light with parallel rays sees of the models: the depth of
// the nearest surface for each texel.
struct ShadowMap {
  Vec3d right, up, forward;  // forward: the way that the light goes
  double left = 0, top = 0;  // of the square around all models
  double side = 1;           // of this square
  int size = 0;              // texels along the side
  std::vector<double> depth;  // by rows, infinity where none is

  // Column and row on the map, with their fractions, and the depth.
  // No division by the depth: rays are parallel.
  Vec3d seen(const Vec3d& p) const {
    const double column = (dot(right, p) - left) * size / side;
    const double row = (top - dot(up, p)) * size / side;
    return {column, row, dot(forward, p)};
  }
  // Rows are counted from the top left.
  std::size_t texel(int column, int row) const {
    const int place = row * size + column;
    return static_cast<std::size_t>(place);
  }
};

using Maps = std::vector<ShadowMap>;  // one for each light

// Twice the area of the triangle a, b, p.
double edge(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// Rounded to 1/256 of a pixel.
Vec2d rounded(const Vec2d& p) {
  return {std::nearbyint(p.x * 256) / 256,
          std::nearbyint(p.y * 256) / 256};
}

using Pixel = std::function<void(int, int, const Vec3d&)>;

// Calls pixel(x, y, weights of the vertices) for all whole x and y
// inside of a triangle, from `low` to below `high`.
void fill(Points p, Vec2i low, Vec2i high, const Pixel& pixel) {
  for (Vec2d& each : p) each = rounded(each);
  const double area = edge(p[0], p[1], p[2]);
  if (area == 0) return;
  const auto [x_low, x_high] =
      std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [y_low, y_high] =
      std::minmax({p[0].y, p[1].y, p[2].y});
  const int x0 = std::max(low.x, round_up(x_low));
  const int x1 = std::min(high.x - 1, round_down(x_high));
  const int y0 = std::max(low.y, round_up(y_low));
  const int y1 = std::min(high.y - 1, round_down(y_high));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const Vec2d here(x, y);
      const double a = edge(p[1], p[2], here);
      const double b = edge(p[2], p[0], here);
      const double c = edge(p[0], p[1], here);
      const Vec3d w = Vec3d(a, b, c) / area;
      if (w.x >= 0 && w.y >= 0 && w.z >= 0) pixel(x, y, w);
    }
  }
}

// A camera that looks along the light. The square holds all models,
// and a margin of two texels.
ShadowMap empty_map(const Triangles& all, const Light& light,
                    int size) {
  ShadowMap map;
  map.size = size;
  const auto side = static_cast<std::size_t>(size);
  map.depth.assign(side * side, infinity);
  map.forward = -light.direction / length(light.direction);
  const bool steep = std::abs(map.forward.y) >= 0.9;
  const Vec3d above = steep ? Vec3d(0, 0, 1) : Vec3d(0, 1, 0);
  const Vec3d across = cross(above, map.forward);
  map.right = across / length(across);
  map.up = cross(map.forward, map.right);
  Vec2d low(infinity), high(-infinity);
  for (const Triangle& triangle : all) {
    for (const Vec3d& p : triangle) {
      const double x = dot(map.right, p), y = dot(map.up, p);
      low = {std::min(low.x, x), std::min(low.y, y)};
      high = {std::max(high.x, x), std::max(high.y, y)};
    }
  }
  const double width = high.x - low.x, height = high.y - low.y;
  map.side = std::max({width, height, 1e-6}) * (1 + 4.0 / size);
  map.left = (low.x + high.x - map.side) / 2;
  map.top = (low.y + high.y + map.side) / 2;
  return map;
}

// The light's picture: a depth buffer, and no colours. A texel's
// depth is that at its centre.
ShadowMap draw_shadow_map(const Triangles& all, const Light& light,
                          int size) {
  ShadowMap map = empty_map(all, light, size);
  const Vec2d half(0.5, 0.5);
  for (const Triangle& triangle : all) {
    const Vec3d a = map.seen(triangle[0]);
    const Vec3d b = map.seen(triangle[1]);
    const Vec3d c = map.seen(triangle[2]);
    const auto store = [&](int column, int row, const Vec3d& w) {
      const double depth = w.x * a.z + w.y * b.z + w.z * c.z;
      double& stored = map.depth[map.texel(column, row)];
      if (depth < stored) stored = depth;
    };
    const Points p{Vec2d(a) - half, Vec2d(b) - half,
                   Vec2d(c) - half};
    fill(p, {0, 0}, {size, size}, store);
  }
  return map;
}

// How much nearer to the light a point is taken to be. A texel
// holds one depth for a patch of the surface: from its centre to
// its corner the depth grows by half a diagonal times the slope.
double bias_at(const ShadowMap& map, const Settings& settings,
               const Vec3d& normal) {
  const double along = length(cross(normal, map.forward));
  const double towards = std::abs(dot(normal, map.forward));
  const double slope = std::min(along / towards, 100.0);
  const double rounding = 1e-6;
  double texels = settings.shadow_slope_bias;
  // The need, and the rounding of vertices.
  if (texels < 0) texels = std::sqrt(2.0) / 2 + 1 / 256.0;
  const double depth = texels * map.side / map.size * slope;
  return settings.shadow_bias + depth + rounding;
}

// Does the map hold something nearer to the light than the point?
bool in_shadow(const ShadowMap& map, const Settings& settings,
               const Vec3d& point, const Vec3d& normal) {
  const Vec3d seen = map.seen(point);
  PS_WATCH("column, row, depth", seen);
  const int column = round_down(seen.x), row = round_down(seen.y);
  if (column < 0 || column >= map.size) return false;
  if (row < 0 || row >= map.size) return false;
  const double stored = map.depth[map.texel(column, row)];
  PS_WATCH("stored depth", stored);
  const double bias = bias_at(map, settings, normal);
  PS_WATCH("bias", bias);
  return stored < seen.z - bias;
}

// Chapter 3, without the lights that do not see the point p.
double compute_illumination(const BookScene& scene,
                            const Maps& maps, Vec3d p, Vec3d n,
                            double specular) {
  const Settings& settings = scene.settings;
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
      const bool shadow = in_shadow(maps[i], settings, p, n);
      PS_WATCH("in shadow", shadow);
      if (shadow) continue;
    }
    Vec3d to_light = light.direction;
    if (light.kind == LightKind::point)
      to_light = light.position - p;
    PS_WATCH("to light", to_light);
    const double n_dot_l = dot(to_light, n);
    const double diffuse = n_dot_l / length(to_light);
    PS_WATCH("cosine to the light", diffuse);
    if (diffuse > 0) intensity += diffuse * light.intensity;
    if (settings.specular && specular != -1) {
      const Vec3d reflected = n * (2 * n_dot_l) - to_light;
      const Vec3d view = scene.camera.position - p;
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

Vec2d project(const BookScene& scene, const Vec3d& p) {
  const double d = scene.camera.projection_plane_d;
  const double vw = scene.camera.viewport_width;
  const double vh = scene.camera.viewport_height;
  return {p.x * d / p.z * scene.width / vw,
          p.y * d / p.z * scene.height / vh};
}

// The camera's picture. The point of a pixel is found from the
// world's vertices, for it is the light that asks.
void draw_triangle(const BookScene& scene, BookCanvas& canvas,
                   const Maps& maps, const Triangle& world,
                   const Triangle& seen,
                   const BookSurface& surface) {
  const Vec3d side = world[1] - world[0];
  const Vec3d across = cross(side, world[2] - world[0]);
  const Vec3d normal = across / length(across);
  const auto shade = [&](int x, int y, const Vec3d& w) {
    PS_PIXEL(x, y);
    const double a = w.x / seen[0].z;
    const double b = w.y / seen[1].z;
    const double c = w.z / seen[2].z;
    const double inverse_z = a + b + c;
    PS_WATCH("1/z", inverse_z);
    if (!canvas.nearer(x, y, inverse_z)) return;
    const Vec3d sum = world[0] * a + world[1] * b + world[2] * c;
    const Vec3d point = sum / inverse_z;
    PS_WATCH("point", point);
    const double intensity = compute_illumination(
        scene, maps, point, normal, surface.specular);
    PS_WATCH("intensity", intensity);
    const Vec3d colour = surface.colour * intensity;
    canvas.put_pixel(x, y, colour);
    PS_WATCH("colour", colour);
  };
  const Points p{project(scene, seen[0]), project(scene, seen[1]),
                 project(scene, seen[2])};
  const Vec2i low(canvas.left(), canvas.bottom());
  const Vec2i high(canvas.right(), canvas.top());
  fill(p, low, high, shade);
}

Triangles world_triangles(const BookInstance& instance) {
  const Transform& t = instance.instance->transform;
  const Mat4d to_world = model_to_world(t);
  const auto& positions = instance.model->positions;
  Triangles all;
  for (const MeshTriangle& face : instance.model->triangles) {
    Triangle world;
    for (std::size_t k = 0; k < 3; ++k) {
      world[k] = transform(to_world, positions[face.position[k]]);
    }
    all.push_back(world);
  }
  return all;
}

// The maps of the directional lights, each of all models.
Maps draw_maps(const BookScene& scene) {
  Triangles all;
  for (const BookInstance& instance : scene.instances)
    for (const Triangle& triangle : world_triangles(instance))
      all.push_back(triangle);
  const int size = scene.settings.shadow_map_size;
  Maps maps(scene.lights.size());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const Light& light = scene.lights[i];
    if (light.kind == LightKind::directional)
      maps[i] = draw_shadow_map(all, light, size);
  }
  return maps;
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const Maps maps = draw_maps(scene);
  const Mat4d to_camera = world_to_camera(scene.camera);
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Triangles world = world_triangles(instance);
    for (std::size_t i = 0; i < world.size(); ++i) {
      const MeshTriangle& face = instance.model->triangles[i];
      PS_REACHING("triangle", instance.number_of(face));
      Triangle seen;
      bool whole = true;
      for (std::size_t k = 0; k < 3; ++k) {
        PS_EACH("vertex", k);
        seen[k] = transform(to_camera, world[i][k]);
        PS_WATCH("from the camera", seen[k]);
        const Vec2d place = project(scene, seen[k]);
        PS_WATCH("on the canvas", place);
        const bool far = canvas.far_outside(place);
        whole = whole && seen[k].z > 0 && !far;
      }
      const Vec3d side = seen[1] - seen[0];
      const Vec3d normal = cross(side, seen[2] - seen[0]);
      const bool front = dot(-seen[0], normal) > 0;
      if (!whole || !front) continue;
      const BookSurface surface = surface_of(scene, instance, face);
      draw_triangle(scene, canvas, maps, world[i], seen, surface);
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
    .shows = "Lit models with the shadows of directional lights, "
             "from a shadow map for each. Point lights cast none.",
    .order = ListingOrder::object_by_object,
    .reads = {"shadow-map-size", "shadow-bias", "shadow-slope-bias",
              "specular"},
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
    .suits =
        [](const SceneTraits& traits, const Settings& settings) {
          if (!traits.triangles) return 0;
          return settings.shadows == Shadows::map ? 6 : 1;
        },
    .draw = ps::cgfs_15_shadows_in_the_rasterizer::draw,
};
}  // namespace textbook
}  // namespace ps
