#include "study/needs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "frame/display_frame.h"
#include "image/display.h"
#include "image/metrics.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/needs_truth.h"
#include "study/needs_words.h"
#include "study/worst_tile.h"
#include "support/environment.h"
#include "support/settings_with.h"
#include "support/trials.h"

namespace ps::needs_test {
namespace {

Needs needs_of(const std::string& name, double tolerance = 0.05) {
  NeedsRequest request;
  request.scene = load_scene(name);
  request.view = {request.scene.camera, 64, 48};
  request.base = settings_for(request.scene);
  request.tolerance = tolerance;
  request.repeats = 1;
  StudyControl control;
  return find_needs(request, control);
}

std::uint64_t work_of(const Scene& scene, const Settings& settings) {
  Settings scalar = settings;
  scalar.simd = Simd::off;  // SIMD searches count another tree, as wide as the processor's vectors
  const Counters counters = render(scene, {scene.camera, 64, 48}, scalar).counters;
  std::uint64_t work = 0;
  for (const Counter counter :
       {Counter::eye_rays, Counter::shadow_rays, Counter::reflection_rays, Counter::refraction_rays,
        Counter::sphere_tests, Counter::triangle_tests, Counter::solid_tests, Counter::node_visits,
        Counter::coverage_tests, Counter::coverage_regions, Counter::stencil_tests, Counter::fragments,
        Counter::texel_reads, Counter::shadow_map_taps, Counter::environment_reads})
    work += counters.get(counter).value_or(0);  // absent: another renderer's kind of work
  return work;
}

Image<Rgb8> levels_of(const Scene& scene, const Settings& settings) {
  return display_frame(render(scene, {scene.camera, 64, 48}, settings), settings);
}

/// The mean of 8 x 8 samples for each pixel, from a picture that is so many times as wide and high.
Image<Rgb8> averaged(const Scene& scene, const Settings& settings) {
  constexpr int side = 8;
  const Frame frame = render(scene, {scene.camera, 64 * side, 48 * side}, settings);
  Image<Vec3d> means(64, 48);
  for (int y = 0; y < 48 * side; ++y)
    for (int x = 0; x < 64 * side; ++x)
      means.at(x / side, y / side) += Vec3d(frame.colour.at(x, y)) / static_cast<double>(side * side);
  return display_image(means, display_transform(settings));
}

/// The first sentence of what a scene needs: "The scene 'Crates' needs lighting and shadows."
std::string needed_words(const std::string& name, const Needs& needs) {
  const std::string sentence = needs_sentence(name, needs);
  return sentence.substr(0, sentence.find('.'));
}

// A third of the scenes, another one in each run.
TEST(Needs, AdviceAndSentenceAgreeAndNoPictureIsWorseForTheAdvice) {
  const unsigned seed = test::test_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  std::size_t more_exact = 0, tried = 0;
  for (std::size_t i = seed % 3; i < scenes.size(); i += 3 * static_cast<std::size_t>(test::trial_divisor), ++tried) {
    const BuiltinScene& builtin = scenes[i];
    SCOPED_TRACE(builtin.name);
    const Scene scene = load_scene(builtin.name);
    const Settings base = settings_for(scene);
    const Needs needs = needs_of(builtin.name);
    const NeedsTruth truth = needs_truth(base, scene_traits(scene), {scene.camera, 64, 48});
    more_exact += needs.within_tolerance ? 0 : 1;
    EXPECT_LE(needs.increase, 0.05);
    EXPECT_EQ(needs.work, work_of(scene, needs.advice));
    EXPECT_EQ(needs.default_work, work_of(scene, base));
    EXPECT_LE(needs.work, needs.within_tolerance ? needs.default_work : work_of(scene, truth.exact));
    if (truth.plan.samples > 1 && base.sample_position == SamplePosition::centre) {
      const Image<Rgb8> mean = averaged(scene, truth.plan.settings);
      EXPECT_LE(compare_images(mean, levels_of(scene, needs.advice)).flip,
                compare_images(mean, levels_of(scene, base)).flip + 0.05);
    }
    const std::string needed = needed_words(builtin.name, needs);
    for (const FeatureShare& share : needs.shares) {
      if (!share.used) continue;
      const bool is_off = without(share.feature, needs.advice) == needs.advice;
      const bool named = needed.find(share.feature.noun) != std::string::npos;
      EXPECT_FALSE(named && is_off) << needed << ", and the advice has no " << share.feature.noun;
      EXPECT_EQ(named, share.increase > 0.05) << needed;
    }
  }
  EXPECT_LE(more_exact, tried / 2);
}

// Far from the truth as they are, for lack of bounces or of samples, settings do not make every feature a need: what
// counts is how much further from it the picture without the feature is.
TEST(Needs, OnlyTheIncreaseOverTheOwnErrorCounts) {
  for (const char* name : {"cgfs/crates", "cgfs/reflections"}) {
    NeedsRequest request;
    request.scene = load_scene(name);
    request.view = {request.scene.camera, 64, 48};
    request.base = settings_for(request.scene);
    request.base.reflection_depth = 1;
    request.repeats = 1;
    StudyControl control;
    const Needs needs = find_needs(request, control);
    EXPECT_GT(needs.default_error, 0.05) << "edges of one sample, at the least";
    for (const FeatureShare& share : needs.shares) {
      if (!share.used) continue;
      const Settings less = without(share.feature, request.base);
      const bool same = levels_of(request.scene, less) == levels_of(request.scene, request.base);
      if (same) {
        EXPECT_EQ(share.increase, 0) << share.feature.name;
      }
      EXPECT_LE(share.increase, share.error_without);
    }
  }
}

TEST(Needs, ABadTileElsewhereHidesNothing) {
  EXPECT_EQ(worst_increase({0.9, 0.1, 0.2}, {0.9, 0.4, 0.1}), 0.4 - 0.1);
  EXPECT_EQ(worst_increase({0.9, 0.1}, {0.2, 0.1}), 0) << "nothing got worse";
}

TEST(Needs, MirrorsAndShadowsThatShowAreKept) {
  const Needs needs = needs_of("cgfs/reflections");
  EXPECT_EQ(needs.advice.shadows, Shadows::traced);
  EXPECT_GT(needs.advice.reflection_depth, 0);
  for (const FeatureShare& share : needs.shares) {
    if (share.feature.name == "shadows" || share.feature.name == "reflection") {
      EXPECT_TRUE(share.used);
      EXPECT_GT(share.increase, 0.05);
      EXPECT_GT(share.work_share, 0.1);
    }
    if (share.feature.name == "textures" || share.feature.name == "refraction") {
      EXPECT_FALSE(share.used);
      EXPECT_TRUE(share.reason);
    }
  }
}

// A saving that is lost in the noise of times is none, and a loss in the picture must be paid for.
TEST(Needs, NoStepIsTakenForNoise) {
  int accepted = 0;
  for (const char* name : {"cgfs/mirrors", "octree/attenuation", "cgfs/fence", "cgfs/crates"}) {
    const Needs needs = needs_of(name);
    double increase = 0;
    std::uint64_t work = needs.default_work;
    for (const NeedsStep& step : needs.trail) {
      if (!step.accepted) continue;
      ++accepted;
      const double saved = 1 - static_cast<double>(step.work) / static_cast<double>(work);
      const bool simpler = std::any_of(features().begin(), features().end(), [&](const Feature& feature) {
        return step.change == std::string(feature.option) + "=" + std::string(feature.off);
      });
      if (needs.within_tolerance) {
        EXPECT_TRUE(saved >= 0.05 || (simpler && saved >= 0 && step.increase <= increase))
            << name << ": " << step.change;
      }
      increase = step.increase;
      work = step.work;
    }
    EXPECT_EQ(work, needs.work) << name << ": the last step taken is what is advised";
  }
  EXPECT_GT(accepted, 0);
}

TEST(Needs, WhatIsDrawnOnTheCanvasNeedsNoLight) {
  const Needs needs = needs_of("cgfs/lines");
  for (const FeatureShare& share : needs.shares) {
    EXPECT_FALSE(share.used) << share.feature.name;
    EXPECT_TRUE(share.reason);
  }
  EXPECT_EQ(needs.advice.lighting, settings_for(load_scene("cgfs/lines")).lighting);
}

TEST(Needs, AZeroToleranceChangesNoPixelAndALargeOneDropsMore) {
  const Needs exact = needs_of("cgfs/reflections", 0), loose = needs_of("cgfs/reflections", 0.9);
  EXPECT_EQ(exact.increase, 0);
  EXPECT_LT(loose.work, exact.work);
}

// A feature is used only where the picture without it is another one. Fragments cast no shadow rays.
TEST(Needs, TracedShadowsAreNoFeatureOfFragments) {
  const Scene scene = load_scene("cgfs/shading");
  const Feature& shadows = *std::find_if(features().begin(), features().end(),
                                         [](const Feature& feature) { return feature.option == "shadows"; });
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer})
    for (const Shadows how : {Shadows::traced, Shadows::map}) {
      Settings settings = settings_for(scene, renderer);
      settings.shadows = how;
      const auto picture = [&](const Settings& of) { return render(scene, {scene.camera, 64, 64}, of).colour; };
      const bool seen = picture(settings) != picture(without(shadows, settings));
      EXPECT_EQ(!unused_reason(shadows, settings, scene_traits(scene)), seen);
      EXPECT_EQ(seen, renderer == Renderer::ray_tracer || how == Shadows::map);
    }
}

}  // namespace
}  // namespace ps::needs_test
