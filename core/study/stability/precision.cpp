#include "frame/display_frame.h"
#include "image/metrics.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/stability/support.h"

namespace ps::stability::precision {
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

void measure(const StabilityRun& run, Rows& rows) {
  const Scene scene = load_scene("cgfs/reflections");
  const auto levels = [&](const Settings& settings) {
    return display_frame(picture_of(scene, {scene.camera, 600, 600}, settings, Channel::none, run), settings);
  };
  const auto differing = [](const Comparison& c) { return static_cast<double>(c.differing); };
  Settings offset;
  offset.sample_position = SamplePosition::corner;
  Settings offset_double = offset;
  offset_double.precision = Precision::float64;
  const Image<Rgb8> robust_double = levels(offset_double);
  const Comparison robust = compare_channels(levels(offset), robust_double);
  // In double epsilons of a millionth are enough, and drop nothing that can be seen.
  Settings small = book(Precision::float64, 1e-6);
  small.shadow_epsilon = 1e-6;
  const Image<Rgb8> truth = levels(small);
  const double robust_alone = differing(compare_channels(robust_double, truth));
  for (const double epsilon : {1e-3, 1e-2, 1e-1}) {
    const Image<Rgb8> wide = levels(book(Precision::float64, epsilon));
    const Comparison naive = compare_channels(levels(book(Precision::float32, epsilon)), wide);
    rows.add(epsilon, "float against double", differing(naive), differing(robust), "px of 360,000 differ");
    rows.add(epsilon, "float against double, size", naive.rmse, robust.rmse, "RMSE, levels");
    rows.add(epsilon, "float against double, largest", naive.max, robust.max, "levels");
    rows.add(epsilon, "the epsilons alone, in double", differing(compare_channels(wide, truth)), robust_alone,
             "px of 360,000 differ");
  }
}

StabilityPicture picture(double epsilon) {
  StabilityPicture picture{.scene = "cgfs/reflections"};
  picture.naive = book(Precision::float32, epsilon);
  picture.robust = book(Precision::float64, epsilon);
  picture.robust.self_hit = SelfHit::offset;
  return picture;
}

}  // namespace

extern const StabilityExperiment precision{
    .key = "precision",
    .place = {Subject::numbers, 80},
    .set_up = SetUp::reproduction,
    .title = "Float against double",
    .keywords = "float, double, single precision, rounding error",
    .knob = "reflection epsilon (ray parameter)",
    .naive = "the book's tests with an epsilon",
    .robust = "offset by the error bound, no epsilon",
    .explanation = "In float the ground reflects itself near the horizon, in double it does not. A larger epsilon "
                   "makes the two more alike, and both less accurate.",
    .safe = "No epsilon: the offset gives the same picture in both but for a few pixels.",
    .window = nowhere_safe,
    .series = {{.names = "float against double|the epsilons alone, in double",
                .title = "pixels that differ",
                .unit = "px of 360,000"},
               {.names = "float against double, size",
                .title = "size of the differences (RMSE)",
                .unit = "levels of 255"},
               {.names = "float against double, largest", .title = "largest difference", .unit = "levels of 255"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {1e-3, 1e-2, 1e-1}};

}  // namespace ps::stability::precision
