#include <array>
#include <cmath>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_15_relief {
namespace {

using Corners = std::array<Vec3d, 3>;
using Points = std::array<Vec2d, 3>;

// A triangle in the world, and how its pictures lie on it.
struct Triangle {
  Corners vertex, normal;
  Points uv;
  BookSurface surface;
};

// The directions on a surface in which the relief is described.
struct Tangents {
  Vec3d along_u, up;  // where u grows, and where v falls
};

// The axes that the red, green and blue of a texel go along.
struct Axes {
  Vec3d t, b, n;
};

Vec3d unit(const Vec3d& v) {
  const double size = length(v);
  return v / size;
}

// Twice the area of a triangle in the texture. Its sign says which
// way round it lies there.
double texture_area(const Points& uv) {
  const Vec2d s = uv[1] - uv[0], t = uv[2] - uv[0];
  return s.x * t.y - t.x * s.y;
}

// Two edges of the triangle go a known way in space and another in
// the texture. Their mix in which v stays is the way along u.
Tangents tangents(const Corners& p, const Points& uv) {
  const Vec3d first = p[1] - p[0], second = p[2] - p[0];
  const Vec2d s = uv[1] - uv[0], t = uv[2] - uv[0];
  const double area = texture_area(uv);
  PS_WATCH("area in the texture", area);
  const Vec3d along_u = (first * t.y - second * s.y) / area;
  PS_WATCH("along u", along_u);
  const Vec3d along_v = (second * s.x - first * t.x) / area;
  PS_WATCH("along v", along_v);
  return {along_u, -along_v};
}

// Perpendicular to each other and 1 long. A texture may lie on the
// surface as in a mirror: then B is on the other side.
Axes axes_of(const Tangents& surface, Vec3d normal) {
  const Vec3d n = unit(normal);
  PS_WATCH("N", n);
  const Vec3d t =
      unit(surface.along_u - n * dot(n, surface.along_u));
  PS_WATCH("T", t);
  const Vec3d side = cross(t, n);
  const double sign = dot(side, surface.up) < 0 ? -1 : 1;
  PS_WATCH("handedness", sign);
  const Vec3d b = side * sign;
  PS_WATCH("B", b);
  return {t, b, n};
}

// Levels from 0 to 255 stand for numbers from -1 to 1.
Vec3d stored_normal(const Vec3d& texel) {
  return texel / 255.0 * 2.0 - Vec3d(1, 1, 1);
}

// The normal that the relief has, in the world.
Vec3d bend_normal(const Axes& axes, Vec3d stored) {
  return unit(axes.t * stored.x + axes.b * stored.y +
              axes.n * stored.z);
}

// Beyond its border the texture begins anew.
int repeated(double place, int size) {
  const double rest = std::fmod(place, size);
  return static_cast<int>(rest < 0 ? rest + size : rest);
}

// The four texels around a place, by how near each of them is.
Vec3d read_texture(const Texture& texture, Vec2d uv) {
  const int width = texture.texels->width();
  const int height = texture.texels->height();
  const double x = uv.x * width - 0.5, y = uv.y * height - 0.5;
  const double column = std::floor(x), row = std::floor(y);
  const auto texel = [&](double right, double down) {
    const int line = repeated(row + down, height);
    const int place = repeated(column + right, width);
    const int index = line * width + place;
    return texel_of(texture, static_cast<std::size_t>(index));
  };
  const double f = x - column, g = y - row;
  const Vec3d upper = texel(0, 0) * (1 - f) + texel(1, 0) * f;
  const Vec3d lower = texel(0, 1) * (1 - f) + texel(1, 1) * f;
  return upper * (1 - g) + lower * g;
}

// Diffuse light of chapter 3.
double light_on(const BookScene& scene, Vec3d point, Vec3d n) {
  double intensity = 0;
  for (const Light& light : scene.lights) {
    PS_EACH("light", kind_name(light));
    if (light.kind == LightKind::ambient) {
      intensity += light.intensity;
      PS_WATCH("intensity so far", intensity);
      continue;
    }
    Vec3d to_light = light.direction;
    if (light.kind == LightKind::point)
      to_light = light.position - point;
    PS_WATCH("to light", to_light);
    const double cosine = dot(n, unit(to_light));
    PS_WATCH("cosine to the light", cosine);
    if (cosine > 0) intensity += cosine * light.intensity;
    PS_WATCH("intensity so far", intensity);
  }
  return intensity;
}

Vec3d colour_of(const BookScene& scene, const Triangle& triangle,
                Vec3d w) {
  const Corners& p = triangle.vertex;
  const Corners& n = triangle.normal;
  const Points& at = triangle.uv;
  const Vec3d point = p[0] * w.x + p[1] * w.y + p[2] * w.z;
  Vec3d normal = n[0] * w.x + n[1] * w.y + n[2] * w.z;
  const Vec2d uv = at[0] * w.x + at[1] * w.y + at[2] * w.z;
  PS_WATCH("u, v", uv);
  const BookSurface& surface = triangle.surface;
  if (surface.normal_map) {
    const Axes axes = axes_of(tangents(p, at), normal);
    const Vec3d texel = read_texture(*surface.normal_map, uv);
    PS_WATCH("texel of the normal map", texel);
    const Vec3d stored = stored_normal(texel);
    PS_WATCH("stored normal", stored);
    normal = bend_normal(axes, stored);
    PS_WATCH("normal in the world", normal);
  }
  Vec3d colour = surface.colour;
  if (surface.texture)
    colour = colour * read_texture(*surface.texture, uv) / 255.0;
  PS_WATCH("local colour", colour);
  const double intensity = light_on(scene, point, unit(normal));
  PS_WATCH("intensity", intensity);
  return colour * intensity;
}

// How much of each vertex it takes to come to a direction whose z
// is 1. Together they are 1/z of the point that is seen there.
Vec3d weights(const Corners& seen, Vec3d direction) {
  const Vec3d parts(dot(direction, cross(seen[1], seen[2])),
                    dot(direction, cross(seen[2], seen[0])),
                    dot(direction, cross(seen[0], seen[1])));
  return parts / dot(seen[0], cross(seen[1], seen[2]));
}

void draw_triangle(const BookScene& scene, BookCanvas& canvas,
                   const Triangle& triangle) {
  const Camera& camera = scene.camera;
  const double d = camera.projection_plane_d;
  const double pixel = camera.viewport_height / scene.height / d;
  const Mat4d to_camera = world_to_camera(camera);
  Corners seen;
  for (std::size_t k = 0; k < 3; ++k)
    seen[k] = transform(to_camera, triangle.vertex[k]);
  // Triangles that reach behind the camera need clipping.
  if (!(seen[0].z > 0 && seen[1].z > 0 && seen[2].z > 0)) return;
  for (int y = canvas.bottom(); y < canvas.top(); ++y) {
    for (int x = canvas.left(); x < canvas.right(); ++x) {
      const Vec3d direction(x * pixel, y * pixel, 1);
      const Vec3d w = weights(seen, direction);
      if (!(w.x >= 0 && w.y >= 0 && w.z >= 0)) continue;
      PS_PIXEL(x, y);
      const double inverse_z = w.x + w.y + w.z;
      if (!canvas.nearer(x, y, inverse_z)) continue;
      const Vec3d colour =
          colour_of(scene, triangle, w / inverse_z);
      PS_WATCH("colour", colour);
      canvas.put_pixel(x, y, colour);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Transform& t = instance.instance->transform;
    const Mat4d to_world = model_to_world(t);
    const Mat4d rotate = rotation_matrix(t.rotation);
    const Mesh& mesh = *instance.model;
    for (const MeshTriangle& face : mesh.triangles) {
      PS_REACHING("triangle", instance.number_of(face));
      Triangle triangle;
      Corners& v = triangle.vertex;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& vertex = mesh.positions[face.position[k]];
        v[k] = transform(to_world, vertex);
        triangle.uv[k] = {0, 0};
        const auto index = static_cast<std::size_t>(face.uv[k]);
        if (face.uv[k] >= 0) triangle.uv[k] = mesh.uvs[index];
      }
      const Vec3d flat = cross(v[1] - v[0], v[2] - v[0]);
      const Vec3d to_camera = scene.camera.position - v[0];
      if (dot(to_camera, flat) <= 0) continue;  // a back face
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.normal[k] = flat;
        if (face.normal[k] < 0) continue;
        const auto index = static_cast<std::size_t>(face.normal[k]);
        triangle.normal[k] = turn(rotate, mesh.normals[index]);
      }
      triangle.surface = surface_of(scene, instance, face);
      // Without an area there is no way along u.
      if (texture_area(triangle.uv) == 0)
        triangle.surface.normal_map = nullptr;
      draw_triangle(scene, canvas, triangle);
    }
  }
}

}  // namespace
}  // namespace cgfs_15_relief

namespace textbook {
extern const Listing cgfs_15_relief;
const Listing cgfs_15_relief{
    .label = "normal maps",
    .source = "CGFS ch. 15",
    .shows = "Models in diffuse light, with colours and normals "
             "from pictures.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.models = true,
              .light = true,
              .textures = true,
              .normal_maps = true},
    .as_settings =
        [](Settings& settings) {
          settings.backface_culling = true;
          settings.visibility = Visibility::depth_buffer;
          settings.shading = Shading::phong;
          settings.normals = Normals::vertex;
          settings.interpolation = Interpolation::perspective;
          settings.texture_filter = TextureFilter::bilinear;
          settings.texture_wrap = TextureWrap::repeat;
          settings.mapped_normals = MappedNormals::world_frame;
          settings.specular = false;
          settings.subpixel_bits = 12;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.normal_maps && traits.triangles ? 1 : 0;
        },
    .draw = ps::cgfs_15_relief::draw,
};
}  // namespace textbook
}  // namespace ps
