#include <array>

#include "image/metrics.h"
#include "options/scene_settings.h"
#include "render/display_frame.h"
#include "scene/load.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

Settings book(Precision precision, double epsilon) {
  Settings settings;
  settings.precision = precision;
  settings.sample_position = SamplePosition::corner;
  settings.self_hit = SelfHit::epsilon;
  settings.sphere_test = SphereTest::quadratic;
  settings.reflection_epsilon = epsilon;
  return settings;
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  const Scene scene = load_scene("cgfs/reflections");
  const auto levels = [&](const Settings& settings) {
    return display_frame(picture_of(scene, {scene.camera, 600, 600}, settings, Channel::none, run), settings);
  };
  const auto differing = [](const Comparison& c) { return static_cast<double>(c.differing); };
  Settings offset;
  offset.sample_position = SamplePosition::corner;
  Settings offset_double = offset;
  offset_double.precision = Precision::float64;
  const Comparison robust = compare_channels(levels(offset), levels(offset_double));
  Rows rows(run);
  const Image<Rgb8> truth = levels(book(Precision::float64, 1e-3));
  for (const double epsilon : {1e-3, 1e-2, 1e-1}) {
    const Image<Rgb8> wide = levels(book(Precision::float64, epsilon));
    const Comparison naive = compare_channels(levels(book(Precision::float32, epsilon)), wide);
    rows.push_back({epsilon, "float against double", differing(naive), differing(robust), "px of 360,000 differ"});
    rows.push_back({epsilon, "float against double, size", naive.rmse, robust.rmse, "RMSE, levels"});
    rows.push_back({epsilon, "float against double, largest", naive.max, robust.max, "levels"});
    rows.push_back({epsilon, "that epsilon alone, in double", differing(compare_channels(wide, truth)), 0,
                    "px of 360,000 differ"});
  }
  return rows;
}

StabilityPicture picture(double epsilon) {
  StabilityPicture picture{.scene = "cgfs/reflections"};
  picture.naive = book(Precision::float32, epsilon);
  picture.robust = book(Precision::float64, epsilon);
  picture.robust.self_hit = SelfHit::offset;
  return picture;
}

constexpr std::array frames{1e-3, 1e-2, 1e-1};

}  // namespace

const StabilityExperiment precision{
    .key = "precision",
    .title = "Float against double",
    .knob = "reflection epsilon",
    .naive = "the book's epsilon",
    .robust = "bounded offset, no epsilon",
    .explanation =
        "In float the ground mirrors itself near the horizon, in double it does not. A larger epsilon brings "
        "the two together and both away from the truth.",
    .safe = "No epsilon: the offset gives the same picture in both.",
    .window = nowhere_safe,
    .measure = measure,
    .picture = picture,
    .frames = frames};

}  // namespace ps::stability
