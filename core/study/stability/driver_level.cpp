#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "options/renderer_kind.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::driver_level {
namespace {

constexpr int side = 128, texels = 256;
constexpr double distance = 4;          // of the plane's middle from the eye
constexpr double repeats_per_unit = 4;  // facing the eye, a pixel is 8 texels wide: level 3
constexpr double reach = 400;           // half the plane's side

/// A plane through the middle of the view, tilted about the horizontal axis, whose texture is turned in its plane.
std::string plane_text(double tilt_degrees, double turn_degrees) {
  const double tilt = tilt_degrees * pi / 180, turn = turn_degrees * pi / 180;
  const auto corner = [&](double u, double v) {
    return fmt::format("({}, {}, {})", u * reach, v * reach * std::cos(tilt), distance + v * reach * std::sin(tilt));
  };
  const auto uv = [&](double u, double v) {
    const double scale = reach * repeats_per_unit;
    return fmt::format("({}, {})", scale * (u * std::cos(turn) - v * std::sin(turn)) + 0.5,
                       scale * (u * std::sin(turn) + v * std::cos(turn)) + 0.5);
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
Scene noise_plane(double tilt, double turn, const StabilityRun& run) {
  Scene scene = parse_scene(plane_text(tilt, turn), "plane", {});
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
  settings.texture_filter = TextureFilter::trilinear;
  return settings;
}

Renderer hardware() {
  const auto all = renderer_kinds();
  const auto found =
      std::find_if(all.begin(), all.end(), [](const RendererKind& kind) { return kind.key == "hardware"; });
  return static_cast<Renderer>(found - all.begin());
}

/// How many levels above or below the formula's a picture lies in each pixel: the bias of our own lookup that comes
/// nearest to its colour. Of several that come as near, the smallest.
class LevelFinder {
 public:
  LevelFinder(const Scene& scene, const StabilityRun& run) : scene_(scene), run_(run) {
    for (int i = 0; i <= 2 * most_steps; ++i) {
      Settings settings = plain_settings();
      settings.renderer = renderer_for(PictureWay::fragments);
      settings.mip_bias = bias_of(i);
      pictures_.push_back(draw(settings));
    }
  }

  Frame draw(const Settings& settings) const {
    return picture_of(scene_, {scene_.camera, side, side}, settings, Channel::ids | Channel::mip, run_);
  }

  /// Of the pixels that show the plane and whose level is between those of the first and the last: a bias can act in
  /// both directions there.
  std::vector<double> offsets(const Settings& settings) const {
    const Frame frame = draw(settings);
    const Frame& ours = pictures_[most_steps];
    std::vector<double> found;
    for (std::size_t p = 0; p < frame.colour.pixels().size(); ++p) {
      const float level = ours.mip.pixels()[p];
      if (ours.ids.pixels()[p].object < 0 || frame.ids.pixels()[p].object < 0 || level < 1.5f || level > 5.5f) continue;
      found.push_back(offset_at(p, frame.colour.pixels()[p]));
    }
    return found;
  }

  /// RMSE in levels of 255, of the same pixels.
  double error_of(const Settings& settings) const {
    const Frame frame = draw(settings);
    const Frame& ours = pictures_[most_steps];
    double sum = 0, count = 0;
    for (std::size_t p = 0; p < frame.colour.pixels().size(); ++p) {
      const float level = ours.mip.pixels()[p];
      if (ours.ids.pixels()[p].object < 0 || frame.ids.pixels()[p].object < 0 || level < 1.5f || level > 5.5f) continue;
      const Vec3f off = 255.0f * (frame.colour.pixels()[p] - ours.colour.pixels()[p]);
      sum += static_cast<double>(dot(off, off)) / 3;
      ++count;
    }
    return count > 0 ? std::sqrt(sum / count) : 0;
  }

 private:
  static constexpr int most_steps = 24;
  static double bias_of(int i) { return (i - most_steps) / 16.0; }

  double offset_at(std::size_t p, const Vec3f& colour) const {
    const auto distance_to = [&](int i) {
      const Vec3f off = pictures_[static_cast<std::size_t>(i)].colour.pixels()[p] - colour;
      return std::sqrt(dot(off, off));
    };
    constexpr float as_near = 0.25f / 255;  // a quarter of a level of 255
    float nearest = distance_to(0);
    for (int i = 1; i <= 2 * most_steps; ++i) nearest = std::min(nearest, distance_to(i));
    double best = bias_of(0);
    for (int i = 0; i <= 2 * most_steps; ++i)
      if (distance_to(i) <= nearest + as_near && std::abs(bias_of(i)) < std::abs(best)) best = bias_of(i);
    return best;
  }

  const Scene& scene_;
  const StabilityRun& run_;
  std::vector<Frame> pictures_;
};

double share_beyond(const std::vector<double>& offsets, double limit) {
  const auto beyond =
      std::count_if(offsets.begin(), offsets.end(), [&](double offset) { return std::abs(offset) > limit; });
  return percent(static_cast<double>(beyond), static_cast<double>(offsets.size()));
}

double median_of(std::vector<double> offsets) {
  if (offsets.empty()) return std::nan("");
  const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
  std::nth_element(offsets.begin(), middle, offsets.end());
  return *middle;
}

void add_rows(Rows& rows, double knob, const std::string& what, const Scene& scene, const StabilityRun& run) {
  const LevelFinder finder(scene, run);
  Settings shader = plain_settings();
  shader.renderer = hardware();
  shader.hardware_texturing = HardwareTexturing::shader;
  Settings driver = shader;
  driver.hardware_texturing = HardwareTexturing::driver;
  const std::vector<double> by_driver = finder.offsets(driver), by_shader = finder.offsets(shader);
  rows.push_back({knob, what + ", beyond a quarter", share_beyond(by_driver, 0.25), share_beyond(by_shader, 0.25),
                  "% of pixels more than a quarter of a level off"});
  rows.push_back({knob, what + ", median", median_of(by_driver), median_of(by_shader), "levels above the formula's"});
  rows.push_back({knob, what + ", colour", finder.error_of(driver), finder.error_of(shader), "RMSE, levels of 255"});
}

constexpr std::array tilts{0.0, 30.0, 50.0, 65.0, 75.0, 82.0};
constexpr std::array turns{0.0, 11.25, 22.5, 33.75, 45.0};

std::vector<StabilityRow> measure_level(const StabilityRun& run) {
  Rows rows(run);
  for (const double tilt : tilts) add_rows(rows, tilt, "tilted", noise_plane(tilt, 0, run), run);
  for (const double turn : turns) add_rows(rows, turn, "turned", noise_plane(0, turn, run), run);
  return rows;
}

StabilityPicture picture_level(double tilt) {
  StabilityPicture picture{.scene = plane_text(tilt, 0)};
  picture.robust = plain_settings();
  picture.robust.renderer = hardware();
  picture.robust.hardware_texturing = HardwareTexturing::shader;
  picture.naive = picture.robust;
  picture.naive.hardware_texturing = HardwareTexturing::driver;
  return picture;
}

}  // namespace

static constexpr StabilitySeries driver_level_series[]{
    {.names = "tilted, beyond*",
     .title = "pixels more than a quarter of a level off",
     .unit = "%",
     .knob = "tilt of the plane (degrees)"},
    {.names = "tilted, median",
     .title = "middle of the driver's levels, above the formula's",
     .unit = "levels",
     .better = Better::neither,
     .knob = "tilt of the plane (degrees)"},
    {.names = "tilted, colour",
     .title = "difference from the rasterizer (RMSE)",
     .unit = "levels of 255",
     .knob = "tilt of the plane (degrees)"},
    {.names = "turned, beyond*",
     .title = "pixels more than a quarter of a level off, facing the plane",
     .unit = "%",
     .knob = "turn of the texture in its plane (degrees)"},
    {.names = "turned, median",
     .title = "middle of the driver's levels, above the formula's, facing the plane",
     .unit = "levels",
     .better = Better::neither,
     .knob = "turn of the texture in its plane (degrees)"},
    {.names = "turned, colour",
     .title = "difference from the rasterizer (RMSE), facing the plane",
     .unit = "levels of 255",
     .knob = "turn of the texture in its plane (degrees)"},
};

extern const StabilityExperiment driver_level{
    .key = "driver-level",
    .place = {Subject::sampling, 65},
    .title = "Mip levels that a graphics driver chooses",
    .keywords = "LOD selection, hardware, OpenGL, texture unit, derivatives, trilinear, level of detail",
    .knob = "tilt of the plane (degrees)",
    .naive = "the driver's own trilinear filter",
    .robust = "the formula, computed in the fragment shader",
    .explanation = "TO BE WRITTEN. Twice.",
    .safe = "TODO.",
    .window = nowhere_safe,
    .series = driver_level_series,
    .measure = measure_level,
    .picture = picture_level,
    .renderer = "hardware",
    .frames = tilts};

}  // namespace ps::stability::driver_level
