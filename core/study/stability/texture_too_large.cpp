#include <array>
#include <memory>

#include <fmt/format.h>

#include "image/planes.h"
#include "options/renderer_kind.h"
#include "study/stability/support.h"

namespace ps::stability::texture_too_large {
namespace {

constexpr int screen = 256, finest = 2048;

/// A picture of 400 grey discs of radius 8 to 256 texels and a tenth of grain: edges and detail at every size.
std::vector<float> master(std::uint32_t seed) {
  std::vector<float> values(static_cast<std::size_t>(finest) * finest, 0.5f);
  Random random(seed);
  for (int i = 0; i < 400; ++i) {
    const double x = random.between(0, finest), y = random.between(0, finest), r = std::pow(2, random.between(3, 8));
    const auto value = static_cast<float>(random.unit());
    for (int row = std::max(0, static_cast<int>(y - r)); row < std::min<double>(finest, y + r); ++row)
      for (int column = std::max(0, static_cast<int>(x - r)); column < std::min<double>(finest, x + r); ++column)
        if ((column - x) * (column - x) + (row - y) * (row - y) < r * r)
          values[static_cast<std::size_t>(row) * finest + static_cast<std::size_t>(column)] = value;
  }
  for (float& value : values) value = 0.9f * value + 0.1f * static_cast<float>(random.unit());
  return values;
}

/// The same picture with `side` x `side` texels, each the mean of what it covers, rounded to float as texels are.
ScalarImage reduced(const std::vector<float>& values, int side) {
  const int step = finest / side;
  ScalarImage result(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      double sum = 0;
      for (int j = 0; j < step; ++j)
        for (int i = 0; i < step; ++i)
          sum += static_cast<double>(
              values[static_cast<std::size_t>(y * step + j) * finest + static_cast<std::size_t>(x * step + i)]);
      result.at(x, y) = static_cast<double>(static_cast<float>(sum / (step * step)));
    }
  return result;
}

/// A square with these texels that fills the screen.
Scene filled_screen(const ScalarImage& values) {
  Image<Vec3f> texels(values.width(), values.height());
  for (std::size_t i = 0; i < texels.pixels().size(); ++i)
    texels.pixels()[i] = Vec3f(static_cast<float>(values.pixels()[i]));
  Scene scene;
  scene.camera.viewport_width = scene.camera.viewport_height = screen;
  scene.textures = Part<std::vector<Texture>>({{"discs", {}, std::make_shared<const Image<Vec3f>>(std::move(texels))}});
  Material material;
  material.texture = 0;
  scene.materials = Part<std::vector<Material>>({material});
  Geometry geometry;
  geometry.objects.push_back(
      {"square", Solid{Rectangle{{-screen / 2.0, -screen / 2.0, 10}, {screen, 0, 0}, {0, screen, 0}}}});
  scene.geometry = Part<Geometry>(std::move(geometry));
  return scene;
}

/// RMSE in levels of 255 of the rasterizer's picture.
double error_on_screen(const Scene& scene, TextureFilter filter, const ScalarImage& truth, const StabilityRun& run) {
  Settings settings;
  settings.renderer = renderer_for(PictureWay::fragments);
  settings.projection = Projection::orthographic;
  settings.precision = Precision::float64;
  settings.lighting = false;
  settings.texture_filter = filter;
  const Frame frame = picture_of(scene, {scene.camera, screen, screen}, settings, Channel::none, run);
  double sum = 0;
  for (int y = 0; y < screen; ++y)
    for (int x = 0; x < screen; ++x) {
      const double off = 255 * (frame.colour_double.at(x, y).x - truth.at(x, y));
      sum += off * off;
    }
  return std::sqrt(sum / (screen * screen));
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  const std::vector<float> values = master(run.seed);
  const ScalarImage truth = reduced(values, screen);
  Rows rows(run);
  for (const int side : {16, 64, 128, 256, 512, 1024, 2048}) {
    const Scene scene = filled_screen(reduced(values, side));
    rows.push_back({static_cast<double>(side), "256 px of screen",
                    error_on_screen(scene, TextureFilter::nearest, truth, run),
                    error_on_screen(scene, TextureFilter::trilinear, truth, run), "RMSE, levels"});
  }
  return rows;
}

/// A wall of bricks, whose texels are grainy at every size.
StabilityPicture picture(double side) {
  StabilityPicture picture{.scene = fmt::format(R"(
viewport_size = 1 x 1
projection_plane_d = 1
texture {{ name = wall  generator = bricks  size = {} }}
rectangle {{ corner = (-1, -1, 2)  side_a = (2, 0, 0)  side_b = (0, 2, 0)  color = white  texture = wall }}
)",
                                                side)};
  picture.robust.renderer = renderer_for(PictureWay::fragments);
  picture.robust.lighting = false;
  picture.naive = picture.robust;
  picture.naive.texture_filter = TextureFilter::nearest;
  return picture;
}

constexpr std::array sizes{2048.0, 1024.0, 512.0, 256.0};

}  // namespace

static constexpr StabilitySeries texture_too_large_series[]{
    {.names = "*", .title = "error of the picture (RMSE)", .unit = "levels of 255"},
};

extern const StabilityExperiment texture_too_large{
    .key = "texture-too-large",
    .place = {Subject::sampling, 70},
    .title = "Texture aliasing: a texture larger than the screen",
    .keywords = "minification, aliasing, mipmap, shimmer, moire",
    .knob = "texels along a side",
    .naive = "the texel nearest to the pixel's centre",
    .robust = "trilinear: the mip level of the screen's size",
    .explanation = "With more texels than pixels, each pixel shows one of the many texels that it covers. Beyond one "
                   "texel per pixel more memory makes the picture worse.",
    .safe = "One texel per pixel.",
    .window = {256, 256},
    .series = texture_too_large_series,
    .measure = measure,
    .picture = picture,
    .frames = sizes};

}  // namespace ps::stability::texture_too_large
