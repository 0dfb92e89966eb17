#include <array>

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

struct Apart {
  double pixels = 0, rmse = 0, largest = 0;
};

Apart apart(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  Apart result;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgb8 p = a.pixels()[i], q = b.pixels()[i];
    const std::array d{p.r - q.r, p.g - q.g, p.b - q.b};
    int worst = 0;
    for (const int c : d) {
      worst = std::max(worst, std::abs(c));
      result.rmse += c * c;
    }
    result.pixels += worst > 0 ? 1 : 0;
    result.largest = std::max(result.largest, static_cast<double>(worst));
  }
  result.rmse = std::sqrt(result.rmse / (3 * static_cast<double>(a.pixels().size())));
  return result;
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  const Scene scene = load_scene("cgfs/reflections");
  const auto levels = [&](const Settings& settings) {
    return display_frame(picture_of(scene, {scene.camera, 600, 600}, settings, Channel::none, run), settings);
  };
  Settings offset;
  offset.sample_position = SamplePosition::corner;
  Settings offset_double = offset;
  offset_double.precision = Precision::float64;
  const Apart robust = apart(levels(offset), levels(offset_double));
  Rows rows(run);
  const Image<Rgb8> truth = levels(book(Precision::float64, 1e-3));
  for (const double epsilon : {1e-3, 1e-2, 1e-1}) {
    const Image<Rgb8> wide = levels(book(Precision::float64, epsilon));
    const Apart naive = apart(levels(book(Precision::float32, epsilon)), wide);
    rows.push_back({epsilon, "float against double", naive.pixels, robust.pixels, "px of 360,000 differ"});
    rows.push_back({epsilon, "float against double, size", naive.rmse, robust.rmse, "RMSE, levels"});
    rows.push_back({epsilon, "float against double, largest", naive.largest, robust.largest, "levels"});
    rows.push_back({epsilon, "that epsilon alone, in double", apart(wide, truth).pixels, 0, "px of 360,000 differ"});
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
