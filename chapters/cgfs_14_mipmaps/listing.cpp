#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_14_mipmaps {
namespace {

using Corners = std::array<Vec3d, 3>;
using Points = std::array<Vec2d, 3>;

// A texture at one of its sizes, row by row from above.
struct Level {
  int width = 0, height = 0;
  std::vector<Vec3d> texels;
};

// Level 0 is the texture, each further one half as large.
using Levels = std::vector<Level>;

struct Triangle {
  Corners seen;  // from the camera, z along its view
  Points uv;
  Vec3d colour;
  const Levels* levels = nullptr;  // null: no texture
};

// Where a level is one texel wide or high, that texel counts twice.
Vec3d texel_at(const Level& level, int column, int row) {
  column = std::min(column, level.width - 1);
  row = std::min(row, level.height - 1);
  const int index = row * level.width + column;
  return level.texels[static_cast<std::size_t>(index)];
}

// Each texel is the mean of four.
Level half_size(const Level& full) {
  Level half;
  half.width = std::max(1, full.width / 2);
  half.height = std::max(1, full.height / 2);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      const Vec3d upper = texel_at(full, 2 * x, 2 * y) +
                          texel_at(full, 2 * x + 1, 2 * y);
      const Vec3d lower = texel_at(full, 2 * x, 2 * y + 1) +
                          texel_at(full, 2 * x + 1, 2 * y + 1);
      half.texels.push_back((upper + lower) / 4.0);
    }
  }
  return half;
}

Levels levels_of(const Texture& texture) {
  Level base{texture.texels->width(), texture.texels->height(), {}};
  const std::size_t texels = texture.texels->pixels().size();
  for (std::size_t i = 0; i < texels; ++i)
    base.texels.push_back(texel_of(texture, i));
  Levels levels{base};
  while (levels.back().width > 1 || levels.back().height > 1)
    levels.push_back(half_size(levels.back()));
  return levels;
}

// A level that does not exist is black.
const Level& level_of(const Levels& levels, double number) {
  static const Level none{1, 1, {Vec3d(0, 0, 0)}};
  const double count = static_cast<double>(levels.size());
  const bool exists = number >= 0 && number < count;
  return exists ? levels[static_cast<std::size_t>(number)] : none;
}

// Beyond its border the texture begins anew.
int repeated(double place, int size) {
  const double rest = std::fmod(place, size);
  return static_cast<int>(rest < 0 ? rest + size : rest);
}

// The four texels around a place, by how near each of them is.
Vec3d read_level(const Level& level, Vec2d uv) {
  const double x = uv.x * level.width - 0.5;
  const double y = uv.y * level.height - 0.5;
  const double column = std::floor(x), row = std::floor(y);
  const auto texel = [&](double right, double down) {
    return texel_at(level, repeated(column + right, level.width),
                    repeated(row + down, level.height));
  };
  const double f = x - column, g = y - row;
  const Vec3d upper = texel(0, 0) * (1 - f) + texel(1, 0) * f;
  const Vec3d lower = texel(0, 1) * (1 - f) + texel(1, 1) * f;
  return upper * (1 - g) + lower * g;
}

// Between two levels both are read, the nearer one counts more.
Vec3d read_texture(const Levels& levels, Vec2d uv, double level) {
  const double finer = std::floor(level);
  const double f = level - finer;
  const Vec3d sharp = read_level(level_of(levels, finer), uv);
  PS_WATCH("in the finer level", sharp);
  if (f == 0) return sharp;
  const Vec3d soft = read_level(level_of(levels, finer + 1), uv);
  PS_WATCH("in the coarser level", soft);
  return sharp * (1 - f) + soft * f;
}

// The level whose texels are as large as the pixel's footprint,
// which is this many texels of level 0 long.
double choose_level(double texels, double last, double bias) {
  const double wanted = portable::log2(texels) + bias;
  PS_WATCH("wanted level", wanted);
  const double level = std::min(last, std::max(0.0, wanted));
  PS_WATCH("level", level);
  return level;
}

// How many texels u and v move on by when u/z, v/z and 1/z change
// by `step`: the derivative of a quotient.
double texels_moved(const Level& base, Vec3d here, Vec3d step) {
  const Vec2d uv(here.x / here.z, here.y / here.z);
  const double du = (step.x - uv.x * step.z) / here.z;
  const double dv = (step.y - uv.y * step.z) / here.z;
  return length({du * base.width, dv * base.height, 0});
}

// How much of each vertex it takes to come to a direction whose z
// is 1. Together they are 1/z of the point that is seen there.
Vec3d weights(const Corners& v, Vec3d direction) {
  const Vec3d parts(dot(direction, cross(v[1], v[2])),
                    dot(direction, cross(v[2], v[0])),
                    dot(direction, cross(v[0], v[1])));
  return parts / dot(v[0], cross(v[1], v[2]));
}

// u/z, v/z and 1/z, which change evenly over the canvas.
Vec3d values_at(const Triangle& triangle, Vec3d direction) {
  const Vec3d w = weights(triangle.seen, direction);
  const Points& uv = triangle.uv;
  const Vec2d sum = uv[0] * w.x + uv[1] * w.y + uv[2] * w.z;
  return {sum.x, sum.y, w.x + w.y + w.z};
}

Vec3d colour_of(const Triangle& triangle, Vec3d direction,
                double pixel, double bias) {
  if (!triangle.levels) return triangle.colour;
  const Levels& levels = *triangle.levels;
  const Vec3d to_right = direction + Vec3d(pixel, 0, 0);
  const Vec3d to_below = direction - Vec3d(0, pixel, 0);
  const Vec3d here = values_at(triangle, direction);
  const Vec3d right = values_at(triangle, to_right) - here;
  const Vec3d below = values_at(triangle, to_below) - here;
  const double across = texels_moved(levels[0], here, right);
  const double along = texels_moved(levels[0], here, below);
  PS_WATCH("texels to the right, below", Vec2d(across, along));
  const double longer = std::max(across, along);
  const double last = static_cast<double>(levels.size()) - 1;
  const double level = choose_level(longer, last, bias);
  const Vec2d uv(here.x / here.z, here.y / here.z);
  PS_WATCH("u, v", uv);
  return read_texture(levels, uv, level);
}

void draw_triangle(const BookScene& scene, BookCanvas& canvas,
                   const Triangle& triangle) {
  const Camera& camera = scene.camera;
  const double d = camera.projection_plane_d;
  const double pixel = camera.viewport_height / scene.height / d;
  const double bias = scene.settings.mip_bias;
  for (int y = canvas.bottom(); y < canvas.top(); ++y) {
    for (int x = canvas.left(); x < canvas.right(); ++x) {
      const Vec3d direction(x * pixel, y * pixel, 1);
      const Vec3d w = weights(triangle.seen, direction);
      if (!(w.x >= 0 && w.y >= 0 && w.z >= 0)) continue;
      PS_PIXEL(x, y);
      if (!canvas.nearer(x, y, w.x + w.y + w.z)) continue;
      PS_WATCH("weights", w);
      const Vec3d colour =
          colour_of(triangle, direction, pixel, bias);
      PS_WATCH("colour", colour);
      canvas.put_pixel(x, y, colour);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  std::map<const Texture*, Levels> made;
  for (const BookInstance& instance : scene.instances) {
    PS_REACHING("instance", instance.name);
    const Transform& t = instance.instance->transform;
    const Mat4d to_camera =
        world_to_camera(scene.camera) * model_to_world(t);
    const Mesh& mesh = *instance.model;
    for (const MeshTriangle& face : mesh.triangles) {
      PS_REACHING("triangle", instance.number_of(face));
      Triangle triangle;
      bool in_front = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& vertex = mesh.positions[face.position[k]];
        triangle.seen[k] = transform(to_camera, vertex);
        in_front = in_front && triangle.seen[k].z > 0;
        triangle.uv[k] = {0, 0};
        const auto index = static_cast<std::size_t>(face.uv[k]);
        if (face.uv[k] >= 0) triangle.uv[k] = mesh.uvs[index];
      }
      // Triangles that reach behind the camera need clipping.
      if (!in_front) continue;
      const BookSurface surface = surface_of(scene, instance, face);
      triangle.colour = surface.colour;
      if (surface.texture) {
        Levels& levels = made[surface.texture];
        if (levels.empty()) levels = levels_of(*surface.texture);
        triangle.levels = &levels;
      }
      draw_triangle(scene, canvas, triangle);
    }
  }
}

}  // namespace
}  // namespace cgfs_14_mipmaps

namespace textbook {
extern const Listing cgfs_14_mipmaps;
const Listing cgfs_14_mipmaps{
    .label = "mipmaps",
    .source = "CGFS ch. 14",
    .shows = "Textured models without light, each pixel read from "
             "the two levels of a mipmap that suit it.",
    .order = ListingOrder::object_by_object,
    .reads = {"mip-bias"},
    .draws = {.models = true, .textures = true},
    .as_settings =
        [](Settings& settings) {
          settings.backface_culling = false;
          settings.visibility = Visibility::depth_buffer;
          settings.interpolation = Interpolation::perspective;
          settings.texture_filter = TextureFilter::trilinear;
          settings.texture_wrap = TextureWrap::repeat;
          settings.subpixel_bits = 12;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.textures && traits.triangles ? 1 : 0;
        },
    .draw = ps::cgfs_14_mipmaps::draw,
};
}  // namespace textbook
}  // namespace ps
