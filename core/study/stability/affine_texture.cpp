#include <array>
#include <memory>

#include "scene/scene_writer.h"
#include "scene/texture_generator.h"
#include "study/stability/plain_scene.h"
#include "study/stability/support.h"

namespace ps::stability::affine_texture {
namespace {

constexpr double near_z = 1.5, far_z = 9.5, below_eye = 0.5;

/// A strip of `pieces` quadrilaterals, two triangles each, from `first` to `last`, and `across` to both sides of them.
/// The texture coordinate v runs from 0 at the first end to 1 at the last.
Scene strip(const Vec3d& first, const Vec3d& last, const Vec3d& across, int pieces) {
  Mesh mesh;
  mesh.materials = {0};
  for (int i = 0; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    const Vec3d middle = first + (last - first) * share;
    for (const double side : {-1.0, 1.0}) {
      mesh.positions.push_back(middle + across * side);
      mesh.uvs.push_back({(side + 1) / 2, share});
    }
  }
  for (std::uint32_t i = 0; i < 2 * static_cast<std::uint32_t>(pieces); ++i) {
    MeshTriangle triangle;
    triangle.position = i % 2 == 0 ? std::array{i, i + 1, i + 2} : std::array{i, i + 2, i + 1};
    for (std::size_t k = 0; k < 3; ++k) triangle.uv[k] = static_cast<std::int32_t>(triangle.position[k]);
    mesh.triangles.push_back(triangle);
  }
  return plain_scene("strip", std::move(mesh));
}

/// The texture coordinates that the rasterizer interpolates, with vertices rounded to its finest 1/4096 px.
Frame coordinates(const Scene& scene, const View& view, Interpolation interpolation, const StabilityRun& run) {
  Settings settings = unlit_fragments();
  settings.precision = Precision::float64;
  settings.interpolation = interpolation;
  settings.subpixel_bits = 12;
  settings.near = 0.5;
  settings.clipping = Clipping::near_only;  // a cut at the picture's border would add a division
  return picture_of(scene, view, settings, Channel::uv | Channel::ids, run);
}

/// Root mean square error (texels of 512) of v over the rows of a floor between two depths, in a picture 2,048 px high.
double floor_rmse(int pieces, Interpolation interpolation, const StabilityRun& run) {
  constexpr int rows = 2048, column = 8;
  constexpr double texels = 512;
  const Scene scene = strip({0, -below_eye, near_z}, {0, -below_eye, far_z}, {0.1, 0, 0}, pieces);
  const Frame frame = coordinates(scene, {scene.camera, 2 * column, rows}, interpolation, run);
  double sum = 0, count = 0;
  const int horizon = rows / 2;
  for (int row = 0; row < rows; ++row) {
    if (frame.ids.at(column, row).object < 0) continue;
    const double z = below_eye * rows / (row + 0.5 - horizon);  // where the ray through the pixel meets the floor
    const double off = texels * (static_cast<double>(frame.uv.at(column, row).y) - (z - near_z) / (far_z - near_z));
    sum += off * off;
    ++count;
  }
  return std::sqrt(sum / count);
}

/// A wall from z = 1 at the left border of a picture 512 px wide to z = 8 at the right one, which shows 256 texels.
struct Wall {
  static constexpr int width = 512, height = 32;
  static constexpr double first = 1, last = 8, texels = 256;

  /// Texels at a place on the screen, in pixels from the left: where the ray meets the wall, which is straight.
  static double texel(double x) {
    const double share = x / width;
    const double z = 1 / (1 / first + (1 / last - 1 / first) * share);
    return texels * (z - first) / (last - first);
  }

  /// The largest error (texels) over the pixels of a row. `texel_at(x)` is what a method has for pixel x.
  template <class TexelAt>
  static double largest_error(TexelAt&& texel_at) {
    double largest = 0;
    for (int x = 0; x < width; ++x) largest = std::max(largest, std::abs(texel_at(x) - texel(x + 0.5)));
    return largest;
  }

  static double drawn(Interpolation interpolation, const StabilityRun& run) {
    Scene scene = strip({-0.5 * first, 0, first}, {0.5 * last, 0, last}, {0, 0.02, 0}, 1);
    scene.camera.viewport_height = static_cast<double>(height) / width;
    const Frame frame = coordinates(scene, {scene.camera, width, height}, interpolation, run);
    return largest_error([&](int x) { return texels * static_cast<double>(frame.uv.at(x, height / 2).y); });
  }

  /// One division every `step` pixels and even steps between, as software rasterizers did (Hecker, Perspective Texture
  /// Mapping, Game Developer 1995). The program does not have it.
  static double corrected_every(int step) {
    return largest_error([&](int x) {
      const int left = x / step * step, right = std::min(left + step, width);
      const double share = (x + 0.5 - left) / (right - left);
      return texel(left) + (texel(right) - texel(left)) * share;
    });
  }
};

void measure(const StabilityRun& run, Rows& rows) {
  for (const int pieces : {1, 2, 4, 8, 16, 32, 64, 128})
    rows.add(pieces, "floor from z = 1.5 to 9.5", floor_rmse(pieces, Interpolation::affine, run),
             floor_rmse(pieces, Interpolation::perspective, run), "texels of 512 (RMSE)");
  const double perspective = Wall::drawn(Interpolation::perspective, run);
  for (const int step : {4, 8, 16, 32, 64})
    rows.add(step, "wall from z = 1 to 8, px between divisions", Wall::corrected_every(step), perspective,
             "texels of 256 (largest)");
  // No division inside: affine.
  rows.add(Wall::width, "wall from z = 1 to 8, px between divisions", Wall::drawn(Interpolation::affine, run),
           perspective, "texels of 256 (largest)");
}

/// The floor with a board of 8 x 8 squares.
StabilityPicture picture(double pieces) {
  Scene scene = strip({0, -below_eye, near_z}, {0, -below_eye, far_z}, {2, 0, 0}, static_cast<int>(pieces));
  const auto texels = std::make_shared<const Image<Vec3f>>(generate_texture("checker", 64));
  scene.textures = Part<std::vector<Texture>>({Texture{"squares", {}, texels, "checker"}});
  scene.materials.edit([](std::vector<Material>& materials) { materials.front().texture = 0; });
  scene.background = {0.55, 0.67, 0.82};
  scene.camera.forward = {0, -0.18, 1};  // a shifted picture: the floor fills it, and z stays what it is
  scene.camera.viewport_height = 0.36;
  StabilityPicture picture{.scene = write_scene(scene, "."), .width = 240, .height = 160};
  picture.robust = unlit_fragments();
  picture.robust.clipping = Clipping::near_only;
  picture.naive = picture.robust;
  picture.naive.interpolation = Interpolation::affine;
  return picture;
}

}  // namespace

extern const StabilityExperiment affine_texture{
    .key = "affine-texture",
    .place = {Subject::depth, 30},
    .set_up = SetUp::reproduction,
    .title = "Affine texture mapping: textures bend",
    .keywords = "perspective correct, texture warping, PlayStation, interpolation",
    .knob = "pieces along the floor",
    .naive = "interpolate u and v on the screen",
    .robust = "interpolate u/z, v/z and 1/z",
    .explanation =
        "Equal steps on the screen are not equal steps on a surface that recedes from the eye. Twice as many "
        "triangles divide the error by four; one division at each pixel removes it.",
    .safe = "64 pieces: a tenth of a texel.",
    .window = {64, everywhere},
    .series = {{.names = "floor*", .title = "error of the texture coordinates (RMSE)", .unit = "texels of 512"},
               {.names = "wall*",
                .title = "largest error of the texture coordinates",
                .unit = "texels of 256",
                .knob = "distance between divisions (px)"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {1.0, 2.0, 4.0, 8.0, 16.0}};

}  // namespace ps::stability::affine_texture
