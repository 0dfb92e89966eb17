#include "study/reference.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "frame/display_frame.h"
#include "options/robust_rays.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "study/standing.h"

namespace ps::reference_test {
namespace {

/// The scene's settings with the rays that err least: what a sweep of any exact option asks for.
Settings best_of(const Settings& base) {
  Settings best = robust_rays(base);
  best.self_hit = SelfHit::offset;
  return best;
}

Reference reference_of(const Scene& scene, const View& view, const Settings& base, int samples) {
  Progress progress;
  ReferencePlan plan;
  plan.settings = best_of(base);
  plan.samples = plan.fewest_samples = samples;
  return make_reference(scene, view, plan, {}, {}, WorkerPriority::normal, progress);
}

TEST(Reference, OneSampleIsThePlainPictureInDouble) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 48, 36};
  const Settings best = best_of(settings_for(scene));
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
  for (const char* file : {"no-such-file.png", "tests/golden/reference"})
    EXPECT_THROW(make_reference(scene, view, {}, {file, 1}, {}, WorkerPriority::normal, progress), InputError);
}

std::vector<SweepPoint> points_of(const std::vector<std::string>& sweeps, const Settings& base,
                                  const SceneTraits& traits) {
  std::vector<SweepAxis> axes;
  for (const std::string& sweep : sweeps) axes.push_back(parse_sweep_axis(sweep));
  return sweep_points(axes, base, base, traits);
}

// What is common to all points is in the reference, too; only what is swept takes its exact value.
TEST(ReferencePlan, KeepsWhatIsNotSwept) {
  const Scene scene = load_scene("cgfs/reflections");
  const SceneTraits traits = scene_traits(scene);
  const View view{scene.camera, 60, 60};
  Settings base = settings_for(scene);
  base.reflection_depth = 2;
  base.samples_per_pixel = 4;
  base.self_hit = SelfHit::epsilon;
  const ReferencePlan guard = plan_reference(points_of({"self-hit"}, base, traits), base, traits, view, {});
  EXPECT_EQ(guard.samples, 1) << "at the points' own samples";
  Settings expected = base;
  expected.precision = Precision::float64;
  expected.self_hit = SelfHit::offset;
  expected.sphere_test = SphereTest::robust;
  EXPECT_EQ(guard.settings, expected);
  EXPECT_NE(guard.description().find("self-hit=offset"), std::string::npos) << guard.description();
  const ReferencePlan depth = plan_reference(points_of({"reflection-depth=0,3"}, base, traits), base, traits, view, {});
  EXPECT_EQ(depth.settings.reflection_depth, 64);
  EXPECT_EQ(depth.settings.self_hit, SelfHit::epsilon);
  const ReferencePlan sampled =
      plan_reference(points_of({"samples-per-pixel=1,64"}, base, traits), base, traits, view, {});
  EXPECT_EQ(sampled.samples, 256);
  EXPECT_EQ(sampled.settings.reflection_depth, 2);
  const ReferencePlan asked = plan_reference(points_of({"self-hit"}, base, traits), base, traits, view, {{}, 9});
  EXPECT_EQ(asked.samples, 9);
}

TEST(ReferencePlan, TakesTheExactChoiceOfEachRenderer) {
  const Scene scene = load_scene("cgfs/shadows");
  const SceneTraits traits = scene_traits(scene);
  const View view{scene.camera, 60, 60};
  Settings base = settings_for(scene);
  EXPECT_EQ(plan_reference(points_of({"shadows"}, base, traits), base, traits, view, {}).settings.shadows,
            Shadows::traced);
  base.renderer = Renderer::rasterizer;
  const ReferencePlan fragments = plan_reference(points_of({"shadows"}, base, traits), base, traits, view, {});
  EXPECT_EQ(fragments.settings.renderer, Renderer::rasterizer);
  EXPECT_EQ(fragments.settings.shadows, Shadows::stencil_depth_fail);
  const ReferencePlan both =
      plan_reference(points_of({"renderer=ray-tracer,rasterizer"}, base, traits), base, traits, view, {});
  EXPECT_EQ(both.settings.renderer, Renderer::ray_tracer);
}

/// Where the option acts, in one of these, its values can be compared.
const std::vector<Settings>& contexts() {
  static const std::vector<Settings> all = [] {
    std::vector<Settings> settings(3);
    settings[1].renderer = Renderer::rasterizer;
    settings[2].renderer = Renderer::textbook;
    return settings;
  }();
  return all;
}

SceneTraits scene_of_everything() {
  SceneTraits traits = scene_traits(load_scene("cgfs/crates"));
  traits.spheres = traits.triangles = traits.reflective = traits.transparent = true;
  return traits;
}

std::vector<std::string> exact_settings(const Option& option) {
  std::vector<std::string> all;
  for (std::string_view rest = option.truth.exact; !rest.empty();) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    all.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return all;
}

// Every option of the table: what its row asks for is in the truth, and what the average over a pixel decides is held
// against that average. A value with the truth's settings has no error of its own.
TEST(ReferencePlan, IsWhatTheRowOfEachOptionAsksFor) {
  const SceneTraits traits = scene_of_everything();
  const View view{Camera{}, 64, 48};
  for (const Option& option : option_table())
    for (const Settings& base : contexts()) {
      SCOPED_TRACE(fmt::format("{} of {}", option.key, renderer_label(base.renderer)));
      const auto points = points_of({std::string(option.key)}, base, traits);
      if (points.size() < 2) continue;
      const ReferencePlan plan = plan_reference(points, base, traits, view, {});
      EXPECT_EQ(plan.samples > 1, option.truth.kind == TruthKind::pixel_average);
      if (option.truth.exact.empty()) {
        EXPECT_EQ(option.get(plan.settings), option.get(base));
      }
      for (const std::string& exact : exact_settings(option)) {
        Settings expected = plan.settings;
        if (exact.find('|') == std::string::npos) parse_assignment(exact, expected);
        EXPECT_EQ(plan.settings, expected) << exact;
      }
      const std::vector<Standing> standing = standings(points, plan, traits);
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (standing[i] == Standing::truth) {
          EXPECT_EQ(option.get(points[i].value), option.get(plan.settings));
          EXPECT_EQ(plan.samples, 1);
        }
        const bool own = option.truth.kind == TruthKind::exact &&
                         option.truth.exact == fmt::format("{}={}", option.key, option_text(option, points[i].value));
        if (own && !draws_fragments(base.renderer)) {
          EXPECT_EQ(standing[i], Standing::truth) << points[i].label;
        }
      }
      if (option.truth.kind == TruthKind::other_picture && !inactive_reason(option, base, traits)) {
        EXPECT_EQ(std::count(standing.begin(), standing.end(), Standing::compared), 0);
      }
    }
}

// Renderers, textures, tessellation and sampling: one sample of any of them is not the truth for the others.
TEST(ReferencePlan, WhatFewSamplesDoNotDecideIsAveraged) {
  const std::string_view sampling = find_option("samples-per-pixel")->group;
  for (const Option& option : option_table()) {
    const std::string exact(option.truth.exact);
    const bool compares_renderers = exact.find("renderer=") != std::string::npos;
    const bool compares_textures = exact.find("texture-filter=") != std::string::npos || option.key == "textures";
    const bool tessellates = exact.find("tessellation=") != std::string::npos;
    if (compares_renderers || compares_textures || tessellates || option.group == sampling) {
      EXPECT_EQ(option.truth.kind, TruthKind::pixel_average) << option.key;
    }
  }
}

// Two mirrors that face each other: each sample is as many rays as it has bounces, so fewer samples are taken.
TEST(ReferencePlan, ManyRaysForASampleLeaveFewerSamples) {
  const Scene mirrors = load_scene("cgfs/mirrors"), plain = load_scene("cgfs/spheres");
  const View view{mirrors.camera, 320, 240};
  const auto samples = [&](const Scene& scene, int depth) {
    Settings base = settings_for(scene);
    base.reflection_depth = depth;
    const SceneTraits traits = scene_traits(scene);
    const auto points = points_of({"renderer=ray-tracer,rasterizer"}, base, traits);
    Prepared prepared;
    Progress progress;
    const ReferencePlan plan = plan_reference(points, base, traits, view, {});
    EXPECT_EQ(plan.samples, 64) << "as far as the size alone shows";
    return affordable(plan, scene, view, {}, prepared, progress).samples;
  };
  EXPECT_EQ(samples(plain, 3), 64);
  EXPECT_LT(samples(mirrors, 64), 64);
  EXPECT_GE(samples(mirrors, 64), 4);
}

TEST(Progress, PartsComeOneAfterTheOther) {
  Progress progress;
  progress.expect_parts(2);
  progress.expect(10);
  EXPECT_EQ(progress.fraction(), 0);
  progress.advance(5);
  EXPECT_EQ(progress.fraction(), 0.25);
  progress.advance(5);
  progress.next_part();
  EXPECT_EQ(progress.fraction(), 0.5) << "not back to the beginning";
  progress.expect(4);
  progress.advance(4);
  EXPECT_EQ(progress.fraction(), 1);
}

// A sweep without values must not ask for more than a machine has.
TEST(ReferencePlan, StaysWithinTheMemoryOfAMachine) {
  const Scene scene = load_scene("cgfs/reflections");
  const SceneTraits traits = scene_traits(scene);
  const Settings base = settings_for(scene);
  const auto points = points_of({"samples-per-pixel"}, base, traits);
  EXPECT_GE(points.size(), 4u);
  const ReferencePlan plan = plan_reference(points, base, traits, {scene.camera, 600, 600}, {});
  EXPECT_LE(plan.samples, 4096);
  EXPECT_GE(plan.samples, 4 * points.back().value.samples_per_pixel);
  Settings fragments = base;
  fragments.renderer = Renderer::rasterizer;
  const auto covered = points_of({"multisampling=1,2,4,8"}, fragments, traits);
  for (const int width : {600, 1920, 3840}) {
    const ReferencePlan large = plan_reference(covered, fragments, traits, {scene.camera, width, width * 9 / 16}, {});
    EXPECT_GE(large.samples, 4);
    EXPECT_LE(static_cast<double>(large.samples) * width * width * 9 / 16, 0x1p25 * 1.01);
  }
}

}  // namespace
}  // namespace ps::reference_test
