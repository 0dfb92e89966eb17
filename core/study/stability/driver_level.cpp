#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "render/renderer_table.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::driver_level {
namespace {

constexpr int side = 128, texels = 256;
constexpr double middle_z = 4;    // of the plane's centre before the eye
constexpr double axis_turn = 20;  // degrees from the horizontal, so that no border between levels is a row of pixels
constexpr double repeats_per_unit = 4;  // facing the eye, a pixel is 8 texels wide: level 3
constexpr double reach = 400;           // half the plane's side

/// A plane through the centre of the view, tilted about an axis across the picture.
std::string plane_text(double tilt_degrees) {
  const double tilt = tilt_degrees * pi / 180;
  const double turn = axis_turn * pi / 180;
  const auto corner = [&](double u, double v) {
    const Vec3d p = reach * Vec3d(u, v * std::cos(tilt), v * std::sin(tilt));
    return fmt::format("({}, {}, {})", p.x * std::cos(turn) - p.y * std::sin(turn),
                       p.x * std::sin(turn) + p.y * std::cos(turn), middle_z + p.z);
  };
  const auto uv = [&](double u, double v) {
    const double scale = reach * repeats_per_unit;
    return fmt::format("({}, {})", scale * u + 0.5, scale * v + 0.5);
  };
  std::string vertices, triangles;
  constexpr std::array<std::array<double, 2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t i = 0; i < 4; ++i) vertices += fmt::format("{} = {}\n", i, corner(corners[i][0], corners[i][1]));
  constexpr std::array<std::array<std::size_t, 3>, 2> faces{{{0, 1, 2}, {0, 2, 3}}};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& f = faces[i];
    triangles += fmt::format("{} = {{ vertices = [{}, {}, {}]  uvs = [{}, {}, {}] }}\n", i, f[0], f[1], f[2],
                             uv(corners[f[0]][0], corners[f[0]][1]), uv(corners[f[1]][0], corners[f[1]][1]),
                             uv(corners[f[2]][0], corners[f[2]][1]));
  }
  return fmt::format(R"(canvas_size = {0} x {0}
viewport_size = 1 x 1
projection_plane_d = 1
background = black
texture {{
    name = squares
    generator = checker
}}
model {{
    name = plane
    texture = squares
    vertices {{
        {1}
    }}
    triangles {{
        {2}
    }}
}}
instance {{
    model = plane
}}
)",
                     side, vertices, triangles);
}

/// The same with random texels, whose means differ from level to level and from place to place.
Scene noise_plane(double tilt, const StabilityRun& run) {
  Scene scene = parse_scene(plane_text(tilt), "plane", {});
  Random random(run.seed);
  Image<Vec3f> noise(texels, texels);
  for (Vec3f& texel : noise.pixels())
    for (int c = 0; c < 3; ++c) texel[c] = static_cast<float>(random.unit());
  scene.textures.edit([&](std::vector<Texture>& textures) {
    textures.front().texels = std::make_shared<const Image<Vec3f>>(std::move(noise));
  });
  return scene;
}

Settings plain_settings() {
  Settings settings;
  settings.lighting = false;
  settings.backface_culling = false;
  settings.near = 0.01;
  settings.texture_filter = TextureFilter::mipmap;
  return settings;
}

/// Whole levels, found out from the colours of a picture: those of our own lookup at some bias that come nearest to it.
/// Of several that come as near, the one with the smallest bias.
class LevelFinder {
 public:
  LevelFinder(const Scene& scene, const StabilityRun& run) : scene_(scene), run_(run) {
    for (int i = -most_steps; i <= most_steps; ++i) {
      Settings settings = plain_settings();
      settings.renderer = renderer_for(PictureWay::fragments);
      settings.mip_bias = i / 8.0;
      pictures_.push_back(draw(settings));
    }
  }

  Frame draw(const Settings& settings) const {
    return picture_of(scene_, {scene_.camera, side, side}, settings, Channel::ids | Channel::mip, run_);
  }

  /// Of each pixel that shows the plane in both pictures; -1 elsewhere, and where the formula's level is too near to
  /// the first or the last for a bias to act both ways.
  Image<int> levels(const Frame& frame) const {
    Image<int> levels(side, side, -1);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const float level = formula().mip.at(x, y);
        if (formula().ids.at(x, y).object < 0 || frame.ids.at(x, y).object < 0 || level < 1.5f || level > 5.5f)
          continue;
        levels.at(x, y) = level_at(x, y, frame.colour.at(x, y));
      }
    return levels;
  }

  const Frame& formula() const { return pictures_[most_steps]; }

 private:
  static constexpr int most_steps = 12;

  int level_at(int x, int y, const Vec3f& colour) const {
    constexpr float as_near = 0.25f / 255;  // a quarter of a level of 255
    float nearest = 1e9f;
    int level = 0;
    for (int step = 0; step <= 2 * most_steps; ++step) {
      const int away = (step + 1) / 2;  // 0, 1, 1, 2, 2: the smallest biases first
      const int bias = most_steps + (step % 2 == 0 ? away : -away);
      const Frame& ours = pictures_[static_cast<std::size_t>(bias)];
      const Vec3f off = ours.colour.at(x, y) - colour;
      const float distance = std::sqrt(dot(off, off));
      if (distance >= nearest - as_near) continue;
      nearest = distance;
      level = static_cast<int>(std::lround(ours.mip.at(x, y)));
    }
    return level;
  }

  const Scene& scene_;
  const StabilityRun& run_;
  std::vector<Frame> pictures_;
};

/// Percentage of pixels at another level than the formula's.
double other_levels(const Image<int>& levels, const Image<int>& formula) {
  double pixels = 0, other = 0;
  for (std::size_t p = 0; p < levels.pixels().size(); ++p) {
    if (levels.pixels()[p] < 0 || formula.pixels()[p] < 0) continue;
    ++pixels;
    other += levels.pixels()[p] == formula.pixels()[p] ? 0 : 1;
  }
  return percent(other, pixels);
}

/// Percentage of the borders between two levels, one pixel above the other, that run through a block of 2 x 2 pixels.
double borders_in_blocks(const Image<int>& levels) {
  double borders = 0, inside = 0;
  for (int y = 0; y + 1 < levels.height(); ++y)
    for (int x = 0; x < levels.width(); ++x) {
      const int above = levels.at(x, y), below = levels.at(x, y + 1);
      if (above < 0 || below < 0 || above == below) continue;
      ++borders;
      inside += y % 2 == 0 ? 1 : 0;
    }
  return percent(inside, borders);
}

/// Levels of 255, over the pixels that have a level.
double colour_error(const Frame& frame, const Frame& formula, const Image<int>& levels) {
  double sum = 0, pixels = 0;
  for (std::size_t p = 0; p < levels.pixels().size(); ++p) {
    if (levels.pixels()[p] < 0) continue;
    const Vec3f off = 255.0f * (frame.colour.pixels()[p] - formula.colour.pixels()[p]);
    sum += static_cast<double>(dot(off, off)) / 3;
    ++pixels;
  }
  return pixels > 0 ? std::sqrt(sum / pixels) : 0;
}

constexpr std::array tilts{35.0, 45.0, 55.0, 65.0, 75.0, 80.0};

void measure_level(const StabilityRun& run, Rows& rows) {
  Settings shader = plain_settings();
  shader.renderer = driver_renderer().value();
  shader.hardware_texturing = HardwareTexturing::shader;
  Settings driver = shader;
  driver.hardware_texturing = HardwareTexturing::driver;
  for (const double tilt : tilts) {
    const Scene scene = noise_plane(tilt, run);
    const LevelFinder finder(scene, run);
    const Frame by_driver = finder.draw(driver), by_shader = finder.draw(shader);
    const Image<int> formula = finder.levels(finder.formula());
    const Image<int> driver_levels = finder.levels(by_driver), shader_levels = finder.levels(by_shader);
    rows.add(tilt, "another level", other_levels(driver_levels, formula), other_levels(shader_levels, formula),
             "% of pixels at another level than the rasterizer's");
    rows.add(tilt, "borders inside blocks", borders_in_blocks(driver_levels), borders_in_blocks(shader_levels),
             "% of borders between levels, inside a block of 2 x 2 pixels");
    rows.add(tilt, "colour", colour_error(by_driver, finder.formula(), formula),
             colour_error(by_shader, finder.formula(), formula), "RMSE, levels of 255");
  }
}

StabilityPicture picture_level(double tilt) {
  StabilityPicture picture{.scene = plane_text(tilt)};
  picture.robust = plain_settings();
  picture.robust.renderer = driver_renderer().value();
  picture.robust.hardware_texturing = HardwareTexturing::shader;
  picture.naive = picture.robust;
  picture.naive.hardware_texturing = HardwareTexturing::driver;
  return picture;
}

}  // namespace

extern const StabilityExperiment driver_level{
    .key = "driver-level",
    .place = {Subject::sampling, 65},
    .title = "Mip levels of a graphics driver: one for 2 x 2 pixels",
    .keywords = "LOD selection, hardware, OpenGL, texture unit, quad, derivatives, ddx, level of detail",
    .knob = "tilt of the plane (degrees)",
    .naive = "the driver's own mip level",
    .robust = "the formula in the fragment shader",
    .explanation =
        "A graphics driver takes derivatives as differences within blocks of 2 x 2 pixels, and gives the four one "
        "level "
        "or nearly so. "
        "So its level changes between blocks and hardly ever inside them. The formula has the derivatives of each "
        "pixel, and its level changes anywhere. The more a surface is tilted, the more the derivatives differ inside a "
        "block.",
    .safe = "Surfaces that face the viewer.",
    .window = {nowhere, 35},
    .series = {{.names = "another level", .title = "pixels at another level than the rasterizer's", .unit = "%"},
               {.names = "borders inside blocks",
                .title = "borders between levels that run through a block of 2 x 2 pixels",
                .unit = "%",
                .better = Better::neither},
               {.names = "colour", .title = "difference from the rasterizer (RMSE)", .unit = "levels of 255"}},
    .add_rows = measure_level,
    .picture = picture_level,
    .measures_driver = true,
    .frames = {tilts.begin(), tilts.end()}};

}  // namespace ps::stability::driver_level
