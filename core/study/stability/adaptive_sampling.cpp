#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "base/counters.h"
#include "image/metrics.h"
#include "raytrace/clear/tracer.h"
#include "record/recorder.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::adaptive_sampling {
namespace {

/// The book's three balls on a chequered floor that runs to the horizon, and balls smaller than a pixel. Everything has
/// a quarter of the book's size: a plane shows a texture of 8 x 8 squares on each unit.
std::string scene_text(const std::string& tiny_balls) {
  return R"(
viewport_size = 1 x 1
projection_plane_d = 1
background = black
sphere { center = (0, -0.25, 0.75) radius = 0.25 color = (255, 0, 0) specular = 500 }
sphere { center = (-0.5, 0, 1) radius = 0.25 color = (0, 255, 0) specular = 10 }
sphere { center = (0.5, 0, 1) radius = 0.25 color = (0, 0, 255) specular = 500 }
texture { name = squares  generator = checker  size = 8 }
plane { point = (0, -0.25, 0) normal = (0, 1, 0) color = white texture = squares }
light { type = ambient intensity = 0.25 }
light { type = point intensity = 0.75 position = (0.5, 0.25, 0) }
light { type = directional intensity = 0.25 direction = (1, 4, 4) }
)" + tiny_balls;
}

constexpr int side = 256;  // px; a smaller picture would show other squares

/// A tiny ball in the sky, a third of a pixel wide, at a place in pixels from the picture's top left.
std::string tiny_ball(double x, double y) {
  return fmt::format("sphere {{ center = ({:.6f}, {:.6f}, 1) radius = 0.0006 color = white }}\n",
                     (x - side / 2.0) / side, (side / 2.0 - y) / side);
}

/// One tiny ball in each square of 8 x 8 pixels of the sky, anywhere in its middle.
constexpr int sky_columns = 32, sky_rows = 8, sky_square = 8;
std::string sky_of_tiny_balls() {
  std::string text;
  Random random(7);
  for (int row = 0; row < sky_rows; ++row)
    for (int column = 0; column < sky_columns; ++column) {
      const double x = sky_square * column + random.between(1, sky_square - 1);
      text += tiny_ball(x, sky_square * row + random.between(1, sky_square - 1));
    }
  return text;
}

/// Balls nearer than the book's limit of 1 are seen.
constexpr double near = 0.1;

struct Result {
  double rmse = 0, rays = 0;  ///< levels; eye rays per pixel
  double off = 0;             ///< percentage of pixels with a channel off by more than 8 levels
};

Result compare(const Image<Vec3f>& picture, const Image<Vec3f>& truth, double rays) {
  double off = 0;
  for (std::size_t i = 0; i < truth.pixels().size(); ++i) {
    const Vec3f d = glm::abs(picture.pixels()[i] - truth.pixels()[i]);
    off += std::max({d.x, d.y, d.z}) > 8.0f / 255 ? 1 : 0;
  }
  const auto pixels = static_cast<double>(truth.pixels().size());
  return {255 * compare_channels(picture, truth).rmse, rays / pixels, percent(off, pixels)};
}

/// Corner subdivision of one pixel (Whitted 1980), which the program does not have: a square whose corners differ by
/// more than the threshold is cut in four, at most `most_cuts` times; any other has the mean of its corners.
class SquareCorners {
 public:
  static constexpr int most_cuts = 4, steps = 1 << most_cuts;

  /// `colour_at(i, j)` looks through the place i and j steps from the pixel's top left.
  template <class ColourAt>
  Vec3f mean(float threshold, ColourAt&& colour_at) {
    known_.fill(false);
    return mean(0, 0, steps, threshold, colour_at);
  }

 private:
  static constexpr std::size_t places = steps + 1;

  template <class ColourAt>
  Vec3f mean(int i, int j, int size, float threshold, ColourAt&& colour_at) {
    const auto corner = [&](int x, int y) {
      const std::size_t place = static_cast<std::size_t>(y) * places + static_cast<std::size_t>(x);
      if (!known_[place]) colours_[place] = colour_at(x, y);
      known_[place] = true;
      return colours_[place];
    };
    const std::array all{corner(i, j), corner(i + size, j), corner(i, j + size), corner(i + size, j + size)};
    float difference = 0;
    for (int c = 0; c < 3; ++c) {
      const auto [least, most] = std::minmax({all[0][c], all[1][c], all[2][c], all[3][c]});
      difference = std::max(difference, most - least);
    }
    if (difference <= threshold || size == 1) return (all[0] + all[1] + all[2] + all[3]) * 0.25f;
    const int half = size / 2;
    Vec3f sum(0);
    for (const int y : {j, j + half})
      for (const int x : {i, i + half}) sum += mean(x, y, half, threshold, colour_at);
    return sum * 0.25f;
  }

  std::array<Vec3f, places * places> colours_;
  std::array<bool, places * places> known_{};
};

/// The scene and its truth, of very many samples in each pixel.
class Balls {
 public:
  explicit Balls(const StabilityRun& run)
      : run_(run), scene_(parse_scene(scene_text(tiny_ball(153.6, 51.2)), "balls", ".")),
        sky_(parse_scene(scene_text(sky_of_tiny_balls()), "sky", ".")) {
    truth_ = draw(scene_, with(run.effort < 1 ? 144 : 576, SamplePattern::jitter)).colour;
  }

  static Settings with(int samples, SamplePattern pattern) {
    Settings settings;
    settings.near = near;
    settings.texture_filter = TextureFilter::nearest;
    settings.samples_per_pixel = samples;
    settings.sample_pattern = pattern;
    return settings;
  }

  Result sampled(const Settings& settings) {
    const Frame frame = draw(scene_, settings);
    return compare(frame.colour, truth_, static_cast<double>(frame.counters[Counter::eye_rays]));
  }

  /// Percentage of the sky's tiny balls of which nothing is seen.
  double missed(const Settings& settings) {
    const Image<Vec3f> picture = draw(sky_, settings).colour;
    double missed = 0;
    for (int row = 0; row < sky_rows; ++row)
      for (int column = 0; column < sky_columns; ++column) {
        bool seen = false;
        for (int y = 0; y < sky_square; ++y)
          for (int x = 0; x < sky_square; ++x)
            seen = seen || picture.at(sky_square * column + x, sky_square * row + y).x > 0;
        missed += seen ? 0 : 1;
      }
    return percent(missed, sky_rows * sky_columns);
  }

  /// Rays through the corners of pixels are shared by up to four of them.
  Result corners_subdivided(double levels) {
    const auto inputs = make_trace_inputs<float>(scene_, view(), with(1, SamplePattern::grid), prepared_);
    Silent silent;
    const Tracer<float, Silent> tracer(inputs, silent);
    double rays = 0;
    const auto look = [&](int column, int row, const Vec2d& offset) {
      ++rays;
      return tracer.trace_eye_ray(eye_ray(inputs, column, row, offset)).colour;
    };
    Image<Vec3f> shared(side + 1, side + 1), picture(side, side);
    for (int y = 0; y <= side; ++y)
      for (int x = 0; x <= side; ++x) shared.at(x, y) = look(x, y, Vec2d(0));
    SquareCorners corners;
    constexpr int steps = SquareCorners::steps;
    for (int y = 0; y < side; ++y) {
      run_.check();
      for (int x = 0; x < side; ++x)
        picture.at(x, y) = corners.mean(static_cast<float>(levels / 255), [&](int i, int j) {
          if (i % steps == 0 && j % steps == 0) return shared.at(x + i / steps, y + j / steps);
          return look(x, y, Vec2d(i, j) / double(steps));
        });
    }
    return compare(picture, truth_, rays);
  }

 private:
  View view() const { return {scene_.camera, side, side}; }
  Frame draw(const Scene& scene, const Settings& settings) const {
    return picture_of(scene, view(), settings, Channel::none, run_);
  }

  const StabilityRun& run_;
  Scene scene_, sky_;
  Prepared prepared_;
  Image<Vec3f> truth_;
};

void measure(const StabilityRun& run, Rows& rows) {
  Balls balls(run);
  const Settings everywhere_16 = Balls::with(16, SamplePattern::jitter);
  const Result robust = balls.sampled(everywhere_16);
  const std::string rmse = "RMSE, levels", cost = "eye rays per pixel", share = "% of pixels";
  const auto add = [&](double knob, const std::string& method, const Result& naive) {
    rows.add(knob, "error" + method, naive.rmse, robust.rmse, rmse);
    rows.add(knob, "cost" + method, naive.rays, robust.rays, cost);
    rows.add(knob, "off by 8 levels" + method, naive.off, robust.off, share);
  };
  constexpr std::array thresholds{128.0, 64.0, 16.0, 4.0, 1.0};
  const auto adaptive = [&](double levels) {
    Settings settings = everywhere_16;
    settings.adaptive_sampling = true;
    settings.adaptive_threshold = levels / 255;
    return settings;
  };
  const double never_seen = balls.missed(everywhere_16);
  for (const double levels : thresholds)
    rows.add(levels, "tiny balls in the sky", balls.missed(adaptive(levels)), never_seen, "% missed");
  for (const double levels : thresholds) add(levels, "", balls.sampled(adaptive(levels)));
  for (const double levels : thresholds)
    add(levels, ", corner subdivision (Whitted 1980)", balls.corners_subdivided(levels));
  for (const int samples : {1, 4, 16, 64}) {
    const double knob = samples;
    const Result grid = balls.sampled(Balls::with(samples, SamplePattern::grid));
    const Result jitter = balls.sampled(Balls::with(samples, SamplePattern::jitter));
    rows.add(knob, "grid and jitter", grid.rmse, jitter.rmse, rmse);
    rows.add(knob, "grid and jitter, off by 8 levels", grid.off, jitter.off, share);
  }
}

StabilityPicture picture(double levels) {
  StabilityPicture picture{.scene = scene_text(sky_of_tiny_balls()), .width = side, .height = side};
  picture.robust = Balls::with(16, SamplePattern::jitter);
  picture.naive = picture.robust;
  picture.naive.adaptive_sampling = true;
  picture.naive.adaptive_threshold = levels / 255;
  return picture;
}

}  // namespace

extern const StabilityExperiment adaptive_sampling_misses{
    .key = "adaptive-sampling-misses",
    .place = {Subject::sampling, 30},
    .title = "Adaptive sampling never sees what it missed",
    .keywords = "AA, antialias, supersampling, undersampling, Whitted",
    .knob = "threshold (levels of 255)",
    .naive = "16 jittered samples where the first rays of neighbours differ",
    .robust = "16 jittered samples everywhere",
    .explanation =
        "Adaptive sampling adds samples where first rays differ. What all first rays missed stays missed at any "
        "threshold, so the error keeps a floor while the cost rises.",
    .safe = "Pictures without anything smaller than a pixel.",
    .window = nowhere_safe,
    .series = {{.names = "tiny balls in the sky", .title = "tiny balls that the picture lacks", .unit = "%"},
               {.names = "error|error, *", .title = "error of the picture (RMSE)", .unit = "levels of 255"},
               {.names = "cost|cost, *", .title = "eye rays for each pixel", .unit = "rays"},
               {.names = "off by 8 levels|off by 8 levels, *", .title = "pixels off by at least 8 levels", .unit = "%"},
               {.names = "grid and jitter",
                .title = "error of the picture (RMSE)",
                .unit = "levels of 255",
                .knob = "samples per pixel",
                .naive = "grid",
                .robust = "jittered grid"},
               {.names = "grid and jitter, off by 8 levels",
                .title = "pixels off by at least 8 levels",
                .unit = "%",
                .knob = "samples per pixel",
                .naive = "grid",
                .robust = "jittered grid"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {64.0, 16.0, 4.0, 1.0}};

}  // namespace ps::stability::adaptive_sampling
