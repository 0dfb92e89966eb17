#include <memory>

#include "image/anisotropic.h"
#include "image/mip_level.h"
#include "image/planes.h"
#include "image/texture_sampling.h"
#include "study/stability/support.h"

namespace ps::stability::mipmap_lod {
namespace {

constexpr int width = 256, height = 128, square = 8, texels_per_unit = 64;

/// A floor of squares of 8 texels, 64 texels to a unit, that fills a picture from below the eye to the horizon.
Vec2d floor_at(double column, double row) {
  const double z = height / row;  // the eye is one unit above the floor, a pixel 1/128 of the view's distance
  return {(column - width / 2.0) / height * z, z};
}

struct Floor {
  MipChain chain;
  ScalarImage truth;  ///< levels, of many bilinear lookups in each pixel
};

/// Squares along one axis, 1 and -1 in turns, mixed between the middles of neighbouring texels.
double square_wave(double texel) {
  const auto sign = [](double i) { return static_cast<std::int64_t>(std::floor(i / square)) % 2 == 0 ? 1.0 : -1.0; };
  const double first = std::floor(texel - 0.5), share = texel - 0.5 - first;
  return sign(first) * (1 - share) + sign(first + 1) * share;
}

Floor make_floor(const StabilityRun& run) {
  auto texels = std::make_shared<Image<Vec3f>>(texels_per_unit, texels_per_unit);
  for (int y = 0; y < texels_per_unit; ++y)
    for (int x = 0; x < texels_per_unit; ++x) texels->at(x, y) = Vec3f((x / square + y / square) % 2 == 0 ? 1 : 0);
  Floor floor{make_mip_chain(texels), ScalarImage(width, height)};
  const int side = run.effort < 1 ? 16 : 64;
  for (int row = 0; row < height; ++row) {
    run.check();
    for (int column = 0; column < width; ++column) {
      double sum = 0;
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          // A shift of its own in each row of samples keeps the grid from beating with the squares.
          const double shift = std::fmod(j * 0.6180339887498949, 1.0);
          const Vec2d p = floor_at(column + (i + shift) / side, row + (j + 0.5) / side);
          // Bilinear filtering of a product is the product of both axes' linear ones.
          sum += (1 + square_wave(p.x * texels_per_unit) * square_wave(p.y * texels_per_unit)) / 2;
        }
      floor.truth.at(column, row) = 255 * sum / (side * side);
    }
  }
  return floor;
}

struct Error {
  double whole = 0, far = 0;  ///< RMSE in levels, of the picture and of its quarter next to the horizon
  double texels = 0;          ///< read for a pixel
};

/// Derivatives at the centre of a pixel, in texels.
TextureDerivatives<double> derivatives_at(double x, double y) {
  const Vec2d uv = floor_at(x, y), right = floor_at(x + 0.5, y) - floor_at(x - 0.5, y);
  const double z = height / y;  // the derivative downwards, of z = height / row and x proportional to z
  const Vec2d down(-uv.x / y, -z / y);
  const double size = texels_per_unit;
  return {right * size, down * size};
}

/// `colour_at(x, y)` looks up the floor for the pixel with this centre.
template <class ColourAt>
Error error_of(const Floor& floor, ColourAt&& colour_at) {
  Error error;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const TextureSample<double> seen = colour_at(column + 0.5, row + 0.5);
      const double off = 255 * seen.colour.x - floor.truth.at(column, row);
      error.whole += off * off;
      if (row < height / 4) error.far += off * off;
      error.texels += seen.texels;
    }
  constexpr double pixels = width * height;
  return {std::sqrt(error.whole / pixels), std::sqrt(error.far / (pixels / 4)), error.texels / pixels};
}

Error error_of(const Floor& floor, TextureFilter filter, double bias, int anisotropy) {
  return error_of(floor, [&](double x, double y) {
    const TextureDerivatives<double> derivatives = derivatives_at(x, y);
    TextureLookup<double> lookup{filter, TextureWrap::repeat, 0};
    if (anisotropy > 1) {
      const double size = texels_per_unit;
      const auto footprint = anisotropic_footprint(derivatives, Vec2d(size, size), anisotropy, bias);
      return sample_anisotropic(floor.chain, floor_at(x, y), lookup, footprint);
    }
    lookup.level = mip_level(derivatives, bias);
    return sample_texture(floor.chain, floor_at(x, y), lookup);
  });
}

/// One trilinear lookup at the level of the footprint's short side, or of the square root of its area; the program has
/// neither.
enum class LevelBy { short_side, area };
Error error_of(const Floor& floor, LevelBy by) {
  return error_of(floor, [&](double x, double y) {
    const auto [dx, dy] = derivatives_at(x, y);
    const double shorter = std::sqrt(std::min(dot(dx, dx), dot(dy, dy)));
    const double area = std::abs(dx.x * dy.y - dx.y * dy.x);
    const double level = std::log2(by == LevelBy::short_side ? shorter : std::sqrt(area));
    return sample_texture(floor.chain, floor_at(x, y), {TextureFilter::trilinear, TextureWrap::repeat, level});
  });
}

/// The mean of side x side bilinear lookups in each pixel, of the finest level.
Error supersampled(const Floor& floor, int side) {
  return error_of(floor, [&](double x, double y) {
    TextureSample<double> mean;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const Vec2d place = floor_at(x - 0.5 + (i + 0.5) / side, y - 0.5 + (j + 0.5) / side);
        const auto one = sample_texture(floor.chain, place, {TextureFilter::bilinear, TextureWrap::repeat, 0.0});
        mean.colour += one.colour / static_cast<double>(side * side);
        mean.texels += one.texels;
      }
    return mean;
  });
}

void measure_lod(const StabilityRun& run, Rows& rows) {
  const Floor floor = make_floor(run);
  const Error robust = error_of(floor, TextureFilter::trilinear, 0, 16);
  constexpr double tap = 4;  // a bilinear lookup is one
  const auto add = [&](double knob, const std::string& name, const Error& naive) {
    rows.add(knob, name, naive.whole, robust.whole, "RMSE, levels");
    rows.add(knob, name + ", far quarter", naive.far, robust.far, "RMSE, levels");
    rows.add(knob, name + ", cost", naive.texels / tap, robust.texels / tap, "lookups of 4 texels per pixel");
  };
  add(0, "nearest", error_of(floor, TextureFilter::nearest, 0, 1));
  add(0, "bilinear", error_of(floor, TextureFilter::bilinear, 0, 1));
  for (const double bias : {-2.0, -1.0, -0.5, 0.0, 1.0, 2.0})
    add(bias, "trilinear, bias", error_of(floor, TextureFilter::trilinear, bias, 1));
  add(0, "trilinear, level by the short side", error_of(floor, LevelBy::short_side));
  add(0, "trilinear, level by the area", error_of(floor, LevelBy::area));
  for (const int taps : {2, 4, 8, 16})
    add(taps, "anisotropic, taps", error_of(floor, TextureFilter::trilinear, 0, taps));
  for (const int side : {4, 8}) add(side * side, "many samples, no levels", supersampled(floor, side));
}

/// The floor that is measured, below a sky.
constexpr const char* floor_scene = R"(viewport_size = 1 x 1
projection_plane_d = 1
background = (140, 170, 210)
texture { name = squares  generator = checker  size = 64 }
model {
    name = floor
    texture = squares
    vertices = [(-60, -1, 0.9), (-60, -1, 100), (60, -1, 100), (60, -1, 0.9)]
    uvs = [(-60, 0.9), (-60, 100), (60, 100), (60, 0.9)]
    triangles { 0 = { vertices = [0, 1, 2] uvs = [0, 1, 2] }  1 = { vertices = [0, 2, 3] uvs = [0, 2, 3] } }
}
instance { model = floor }
light { type = ambient  intensity = 1 }
)";

StabilityPicture picture_lod(double bias) {
  StabilityPicture picture{.scene = floor_scene};
  picture.robust.renderer = renderer_for(PictureWay::fragments);
  picture.robust.anisotropy = 16;
  picture.naive = picture.robust;
  picture.naive.anisotropy = 1;
  picture.naive.mip_bias = bias;
  return picture;
}

}  // namespace

extern const StabilityExperiment mipmap_lod{
    .key = "mipmap-lod",
    .place = {Subject::sampling, 60},
    .title = "Mip level (LOD) selection: aliasing against blur",
    .keywords = "LOD selection, mip bias, level of detail, blur, aliasing, minification",
    .knob = "largest number of lookups",
    .naive = "one lookup: nearest, bilinear, or trilinear with a bias",
    .robust = "trilinear, up to 16 lookups along the footprint (anisotropic)",
    .explanation =
        "A pixel of a distant floor covers many texels in depth and few across. One lookup in a square footprint is "
        "either aliased in depth or blurred across; several lookups along the footprint fit both.",
    .safe = "Surfaces that face the viewer.",
    .window = {16, everywhere},
    .series = {{.names = "trilinear, bias|*",
                .title = "error of the floor (RMSE)",
                .unit = "levels of 255",
                .knob = "mip bias (levels)"},
               {.names = "anisotropic, taps", .title = "error of the floor (RMSE)", .unit = "levels of 255"},
               {.names = "trilinear, bias, far quarter|*far quarter",
                .title = "error of the far quarter (RMSE)",
                .unit = "levels of 255",
                .knob = "mip bias (levels)"},
               {.names = "anisotropic, taps, far quarter",
                .title = "error of the far quarter (RMSE)",
                .unit = "levels of 255"},
               {.names = "trilinear, bias, cost|*cost",
                .title = "lookups of 4 texels for each pixel",
                .unit = "lookups",
                .knob = "mip bias (levels)"},
               {.names = "anisotropic, taps, cost", .title = "lookups of 4 texels for each pixel", .unit = "lookups"},
               {.names = "many samples, no levels",
                .title = "error of the floor (RMSE)",
                .unit = "levels of 255",
                .knob = "samples per pixel"},
               {.names = "many samples, no levels, far quarter",
                .title = "error of the far quarter (RMSE)",
                .unit = "levels of 255",
                .knob = "samples per pixel"},
               {.names = "many samples, no levels, cost",
                .title = "lookups of 4 texels for each pixel",
                .unit = "lookups",
                .knob = "samples per pixel"}},
    .add_rows = measure_lod,
    .picture = picture_lod,
    .frames = {-2.0, -1.0, 0.0, 1.0, 2.0}};

}  // namespace ps::stability::mipmap_lod
