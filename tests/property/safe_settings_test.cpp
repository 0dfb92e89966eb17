// The settings that new pictures start with lie in every safe window, and the program knows when a user's do not.
#include <gtest/gtest.h>

#include <algorithm>

#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/stability/experiment.h"
#include "study/stability/pictures.h"
#include "study/unsafe_settings.h"
#include "support/trials.h"

namespace ps::safe_settings_test {
namespace {

TEST(SafeSettings, DefaultsLieInEveryWindowOfEveryBuiltinScene) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    SCOPED_TRACE(builtin.name);
    const Scene scene = load_scene(builtin.name);
    for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
      Settings settings{.renderer = renderer};
      Progress progress;
      EXPECT_TRUE(unsafe_settings(scene, {scene.camera, 160, 120}, settings, progress).empty());
    }
  }
}

/// Scenes may ask for what fails, to show it. What they do not show on purpose must not be seen.
TEST(SafeSettings, ScenesThatAskForAnEpsilonShowNoneOfItsFaults) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    if (builtin.name.rfind("lab/", 0) == 0) continue;
    SCOPED_TRACE(builtin.name);
    const Scene scene = load_scene(builtin.name);
    Progress progress;
    for (const UnsafeSetting& unsafe : unsafe_settings(scene, {scene.camera, 160, 120}, settings_for(scene), progress))
      if (unsafe.option.find("epsilon") != std::string_view::npos || unsafe.option == "self-hit") {
        EXPECT_LE(unsafe.bad_percent, 0.1) << unsafe.option;
      }
  }
}

const UnsafeSetting* find(const std::vector<UnsafeSetting>& list, std::string_view experiment) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& u) { return u.experiment == experiment; });
  return found == list.end() ? nullptr : &*found;
}

TEST(SafeSettings, FaultsAreMeasuredOnTheSceneItself) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 160, 160};
  Settings settings;
  settings.self_hit = SelfHit::epsilon;
  settings.sphere_test = SphereTest::quadratic;
  settings.shadow_epsilon = 0.3;
  Progress progress;
  const auto unsafe = unsafe_settings(scene, view, settings, progress);
  const UnsafeSetting* lost = find(unsafe, "epsilon-too-large");
  ASSERT_TRUE(lost);
  EXPECT_GT(lost->bad_percent, 0.3);
  EXPECT_EQ(lost->value, "0.3");
  EXPECT_EQ(lost->safe, "self-hit=offset");
  EXPECT_TRUE(find(unsafe, "reflection-self-hit"));
  EXPECT_FALSE(find(unsafe, "fill-rule-easy")) << "rays fill nothing";
  EXPECT_TRUE(std::is_sorted(unsafe.begin(), unsafe.end(),
                             [](const auto& a, const auto& b) { return a.bad_percent > b.bad_percent; }));
}

TEST(SafeSettings, NoReflectionsAreAChoiceAndTooFewAreAFault) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 80, 80};
  Progress progress;
  for (const int depth : {0, 1, 2, 3}) {
    SCOPED_TRACE(depth);
    Settings settings;
    settings.reflection_depth = depth;
    const auto unsafe = unsafe_settings(scene, view, settings, progress, {.only_known = true});
    EXPECT_EQ(find(unsafe, "recursion-depth") != nullptr, depth == 1 || depth == 2);
  }
}

TEST(SafeSettings, EveryWarningNamesAnExperimentAndAnOption) {
  int warnings = 0;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const Scene scene = load_scene(builtin.name);
    Progress progress;
    for (const UnsafeSetting& unsafe :
         unsafe_settings(scene, {scene.camera, 40, 30}, settings_for(scene), progress, {.only_known = true})) {
      ++warnings;
      EXPECT_NO_THROW(find_stability_experiment(unsafe.experiment)) << unsafe.experiment;
      EXPECT_TRUE(find_option(unsafe.option)) << unsafe.option;
      Settings safe = settings_for(scene);
      EXPECT_NO_THROW(parse_assignments(unsafe.safe, safe));
      const auto left = unsafe_settings(scene, {scene.camera, 40, 30}, safe, progress, {.only_known = true});
      EXPECT_FALSE(find(left, unsafe.experiment)) << "what is said to be safe is";
    }
  }
  EXPECT_GT(warnings, 3) << "scenes that show faults on purpose";
}

/// Experiments that measure the driver are missing where no renderer uses one.
TEST(SafeSettings, RowsNameExperimentsThatThereAre) {
  int named = 0;
  for (const Option& option : option_table())
    for (const OptionExperiment& experiment : option.shown_by.experiments.list) {
      ++named;
      EXPECT_EQ(experiment.unsafe == nullptr, experiment.safe.empty()) << option.key;
      if (experiment.key.starts_with("driver-")) continue;
      EXPECT_NO_THROW(find_stability_experiment(experiment.key)) << option.key;
    }
  EXPECT_GT(named, 60);
}

TEST(StabilityPictures, EveryPointOpensAndItsFailureIsFound) {
  int failing = 0;
  const auto all = stability_experiments();
  for (std::size_t i = 0; i < all.size(); i += test::list_step) {
    const StabilityExperiment& experiment = all[i];
    SCOPED_TRACE(experiment.key);
    EXPECT_EQ(experiment.picture == nullptr, experiment.frames.empty());
    if (!experiment.picture) continue;
    Progress progress;
    const auto opening = open_stability_point(experiment, experiment.frames.front(), progress);
    ASSERT_TRUE(opening);
    EXPECT_EQ(opening->failing.has_value(), opening->failing_percent > 0);
    failing += opening->failing ? 1 : 0;
  }
  EXPECT_GT(failing, 15 / static_cast<int>(test::list_step));
}

TEST(StabilityPictures, TheStripHoldsAllFrames) {
  const StabilityExperiment& experiment = find_stability_experiment("reflection-self-hit");
  Progress progress;
  const auto strip = film_strip(experiment, {.frame_height = 60, .gap = 2}, progress);
  ASSERT_TRUE(strip);
  const int frames = static_cast<int>(experiment.frames.size());
  EXPECT_EQ(strip->width(), frames * 62 - 2);
  EXPECT_EQ(strip->height(), 3 * 62 - 2);
  // The first epsilon is the smallest and fails, the last one does not: white in the lowest row.
  const auto white = [&](int frame) {
    int count = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x) count += strip->at(frame * 62 + x, 124 + y) == Rgb8{255, 255, 255} ? 1 : 0;
    return count;
  };
  EXPECT_GT(white(0), 60);
  EXPECT_EQ(white(frames - 1), 0);
  EXPECT_FALSE(film_strip(find_stability_experiment("srgb-averaging"), {}, progress));
}

}  // namespace
}  // namespace ps::safe_settings_test
