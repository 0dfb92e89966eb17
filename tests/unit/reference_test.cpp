#include "study/reference.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "options/scene_settings.h"
#include "render/display_frame.h"
#include "scene/load.h"
#include "scene/scene_file.h"

namespace {

using namespace ps;

Reference reference_of(const Scene& scene, const View& view, const Settings& base, int samples) {
  Progress progress;
  return make_reference(scene, view, base, {{}, samples}, {}, WorkerPriority::normal, progress);
}

TEST(Reference, OneSampleIsThePlainPictureInDouble) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 48, 36};
  const Settings best = reference_settings(settings_for(scene), scene_traits(scene));
  EXPECT_EQ(best.precision, Precision::float64);
  const Reference reference = reference_of(scene, view, settings_for(scene), 1);
  EXPECT_EQ(reference.picture.levels, display_frame(render(scene, view, best), best));
  EXPECT_FALSE(reference.halves.has_value());
}

/// The share of a pixel that a half-plane covers is known: the mean of many samples must come to it, for both
/// positions of the one sample, and the picture of the book's corner is that of the centre moved by half a pixel.
TEST(Reference, SamplesLieAroundThePlaceOfTheOneSample) {
  const Scene scene = load_scene("cgfs/spheres");
  for (const SamplePosition position : {SamplePosition::centre, SamplePosition::corner})
    for (const FieldOfViewSpan span : {FieldOfViewSpan::edges, FieldOfViewSpan::centres}) {
      Settings base = settings_for(scene);
      base.sample_position = position;
      base.field_of_view_span = span;
      const View view{scene.camera, 60, 60};
      // An odd number of samples along a side has one in the middle: where one sample would lie. In a picture of one
      // colour for each sphere the mean differs from that sample only at outlines, and on both sides alike.
      const Reference one = reference_of(scene, view, base, 1), many = reference_of(scene, view, base, 25);
      double sum = 0, wrong = 0;
      for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) {
          const Vec3f d = many.picture.linear.at(x, y) - one.picture.linear.at(x, y);
          sum += static_cast<double>(d.x + d.y + d.z);
          wrong += static_cast<double>(std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) > 1e-6 ? 1 : 0;
        }
      EXPECT_LT(wrong, 250) << "only outlines differ";
      EXPECT_GT(wrong, 50);
      EXPECT_LT(std::abs(sum), 12) << "a shift by half a pixel would brighten or darken one side";
    }
}

TEST(Reference, HalvesComeCloserWithMoreSamples) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 40, 40};
  const Reference few = reference_of(scene, view, settings_for(scene), 4);
  const Reference many = reference_of(scene, view, settings_for(scene), 144);
  ASSERT_TRUE(few.halves && many.halves);
  EXPECT_GT(*reference_noise(few, ErrorMetric::rmse), 4 * *reference_noise(many, ErrorMetric::rmse));
  EXPECT_LT(*reference_noise(many, ErrorMetric::rmse), 1.0);
}

TEST(Reference, BadInputIsRefused) {
  const Scene scene = load_scene("cgfs/spheres");
  const View view{scene.camera, 20, 20};
  EXPECT_THROW(reference_of(scene, view, {}, 8), InputError);
  Progress progress;
  EXPECT_THROW(make_reference(scene, view, {}, {"no-such-file.png", 1}, {}, WorkerPriority::normal, progress),
               InputError);
  EXPECT_THROW(make_reference(scene, view, {}, {"tests/golden/reference", 1}, {}, WorkerPriority::normal, progress),
               InputError);
}

}  // namespace
