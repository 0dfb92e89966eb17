#include <array>

#include <fmt/format.h>

#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// Three balls on a floor of fine squares under a sky of balls that are smaller than a pixel.
std::string scene_text() {
  std::string text = R"(
viewport_size = 1 x 1
projection_plane_d = 1
background = black
sphere { center = (0, -0.2, 3) radius = 0.8 color = (220, 60, 40) specular = 100 }
sphere { center = (-1.6, 0, 4) radius = 0.7 color = (60, 160, 60) specular = 10 }
sphere { center = (1.6, 0, 4) radius = 0.7 color = (60, 110, 200) specular = 300 }
texture { name = squares  generator = checker  size = 8 }
plane { point = (0, -1, 0) normal = (0, 1, 0) color = white texture = squares }
light { type = ambient intensity = 0.3 }
light { type = point intensity = 0.7 position = (2, 3, 0) }
)";
  Random random(7);
  for (int i = 0; i < 200; ++i)
    text += fmt::format("sphere {{ center = ({:.4f}, {:.4f}, 4) radius = 0.0025 color = white }}\n",
                        random.between(-1.9, 1.9), random.between(0.9, 1.9));
  return text;
}

struct Result {
  double rmse = 0, rays = 0;
};

std::vector<StabilityRow> measure(const StabilityRun& run) {
  const Scene scene = parse_scene(scene_text(), "balls", ".");
  const int side = run.side(256, 128);
  const auto frame_of = [&](const Settings& settings) {
    return picture_of(scene, {scene.camera, side, side}, settings, Channel::none, run);
  };
  Settings best;
  best.samples_per_pixel = run.effort < 1 ? 256 : 1024;
  const Image<Vec3f> truth = frame_of(best).colour;
  const auto measure_one = [&](const Settings& settings) {
    const Frame frame = frame_of(settings);
    double sum = 0;
    for (std::size_t i = 0; i < truth.pixels().size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const double d = static_cast<double>(frame.colour.pixels()[i][c]) - static_cast<double>(truth.pixels()[i][c]);
        sum += d * d;
      }
    const double pixels = static_cast<double>(truth.pixels().size());
    return Result{255 * std::sqrt(sum / (3 * pixels)), static_cast<double>(frame.counters[Counter::eye_rays]) / pixels};
  };
  Settings jitter;
  jitter.samples_per_pixel = 16;
  jitter.sample_pattern = SamplePattern::jitter;
  const Result robust = measure_one(jitter);
  Rows rows(run);
  for (const double levels : {128.0, 64.0, 16.0, 4.0, 1.0}) {
    Settings adaptive = jitter;
    adaptive.adaptive_sampling = true;
    adaptive.adaptive_threshold = levels / 255;
    const Result naive = measure_one(adaptive);
    rows.push_back({levels, "error", naive.rmse, robust.rmse, "RMSE, levels"});
    rows.push_back({levels, "cost", naive.rays, robust.rays, "eye rays per pixel"});
  }
  return rows;
}

StabilityPicture picture(double levels) {
  StabilityPicture picture{.scene = scene_text()};
  picture.robust.samples_per_pixel = 16;
  picture.robust.sample_pattern = SamplePattern::jitter;
  picture.naive = picture.robust;
  picture.naive.adaptive_sampling = true;
  picture.naive.adaptive_threshold = levels / 255;
  return picture;
}

constexpr std::array frames{64.0, 16.0, 4.0, 1.0};

}  // namespace

const StabilityExperiment adaptive_sampling_misses{
    .key = "adaptive-sampling-misses",
    .title = "Adaptive sampling never sees what it missed",
    .knob = "threshold (levels)",
    .naive = "16 samples where neighbours differ",
    .robust = "16 samples everywhere",
    .explanation = "More samples go where the first ones differ. What all of the first ones missed stays missed at any "
                   "threshold, so the error has a floor while the cost goes on rising.",
    .safe = "Pictures without anything smaller than a pixel.",
    .window = nowhere_safe,
    .measure = measure,
    .picture = picture,
    .frames = frames};

}  // namespace ps::stability
