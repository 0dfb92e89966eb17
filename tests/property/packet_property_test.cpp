// The fast path against the clear path: the same bits on every SIMD target, from anywhere, and the same counts of work.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "raytrace/fast/packet.h"
#include "raytrace/renderer.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/random_scene.h"
#include "support/simd_targets.h"
#include "support/trials.h"

namespace packet_property_test {
namespace {

using namespace ps;

Frame traced(const Scene& scene, const View& view, Settings settings, Simd simd, Prepared& prepared) {
  settings.simd = simd;
  Progress progress;
  RenderRequest request;
  request.channels = Channel::ids | Channel::depth;
  if (!scene_traits(scene).triangles && sampling_plan(settings).mode == SamplingMode::one)
    request.channels = request.channels | Channel::shadow;  // packets store them only then
  return render_traced(scene, view, settings, request, prepared, progress);
}

bool takes_the_fast_path(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared) {
  const Channel channels =
      sampling_plan(settings).mode == SamplingMode::one ? Channel::ids | Channel::shadow : Channel::ids;
  return make_trace_inputs<float>(scene, view, settings, prepared, channels).path.machinery ==
         Machinery::sphere_packets;
}

/// What does not depend on the tree: with triangles, SIMD searches a tree of its own, and from eight lanes on with
/// eight eye rays together.
Counters without_the_search(Counters counters) {
  for (const Counter c : {Counter::node_visits, Counter::triangle_tests, Counter::sphere_tests, Counter::solid_tests})
    counters[c] = 0;
  return counters;
}

/// Trees that several views of a scene share are kept in `prepared`.
void expect_same_on_all_targets(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared) {
  std::vector<Simd> targets = test::simd_targets();
  if (targets.empty()) GTEST_SKIP() << "this processor has no SIMD target: both sides are the clear path";
  targets.push_back(Simd::automatic);
  const Frame clear = traced(scene, view, settings, Simd::off, prepared);
  const bool triangles = scene_traits(scene).triangles;
  const Frame four_lanes = traced(scene, view, settings, Simd::sse4, prepared);
  const Frame eight_lanes = traced(scene, view, settings, Simd::avx2, prepared);
  for (const Simd simd : targets) {
    SCOPED_TRACE(static_cast<int>(simd));
    const Frame fast = traced(scene, view, settings, simd, prepared);
    ASSERT_EQ(
        std::memcmp(clear.colour.pixels().data(), fast.colour.pixels().data(), clear.colour.pixels().size_bytes()), 0);
    ASSERT_EQ(without_the_search(clear.counters), without_the_search(fast.counters));
    const Frame& like = !triangles ? clear : simd == Simd::sse4 ? four_lanes : eight_lanes;
    if (simd != Simd::automatic || !triangles) {
      ASSERT_EQ(like.counters, fast.counters);
    }
    ASSERT_TRUE(clear.ids == fast.ids);
    ASSERT_TRUE(clear.depth == fast.depth);
    ASSERT_TRUE(clear.shadow == fast.shadow);
  }
}

bool takes_the_fast_path(const Scene& scene, const View& view, const Settings& settings) {
  Prepared prepared;
  return takes_the_fast_path(scene, view, settings, prepared);
}

void expect_same_on_all_targets(const Scene& scene, const View& view, const Settings& settings) {
  Prepared prepared;
  expect_same_on_all_targets(scene, view, settings, prepared);
}

double between(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) * 0x1p-32;
}

/// Somewhere around the book's spheres, looking anywhere, the frame neither orthogonal nor of unit length.
Camera random_camera(std::mt19937& random) {
  const auto vector = [&](double size) {
    const double x = between(random, -size, size), y = between(random, -size, size);
    return Vec3d(x, y, between(random, -size, size));
  };
  Camera camera;
  camera.position = vector(4) + Vec3d(0, 3, 2);
  camera.right = Vec3d(1, 0, 0) + vector(0.5);
  camera.up = Vec3d(0, 1, 0) + vector(0.5);
  camera.forward = Vec3d(0, -0.3, 1) + vector(1);
  return camera;
}

TEST(Packets, BookScenesFromAnywhere) {
  constexpr unsigned seed = 61;
  RecordProperty("seed", seed);
  std::mt19937 random(seed);
  int fast = 0;
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  for (std::size_t number = 0; number < scenes.size(); number += test::list_step) {
    const BuiltinScene& entry = scenes[number];
    SCOPED_TRACE(entry.name);
    const Scene scene = load_scene(entry.name);
    Prepared prepared;
    for (int i = 0; i < test::trials(6); ++i) {
      const View view{i == 0 ? scene.camera : random_camera(random), 75 + i, 49};
      fast += takes_the_fast_path(scene, view, {}, prepared) ? 1 : 0;
      expect_same_on_all_targets(scene, view, {}, prepared);
    }
  }
  EXPECT_GE(fast, 4 * test::trials(6) / static_cast<int>(test::list_step))
      << "most scenes with spheres must take the fast path, or this test says nothing";
}

TEST(Packets, EverySettingThatTheFastPathCovers) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 130, 70};
  const auto expect_fast = [&](auto change) {
    Settings settings;
    change(settings);
    EXPECT_TRUE(takes_the_fast_path(scene, view, settings));
    expect_same_on_all_targets(scene, view, settings);
  };
  expect_fast([](Settings& s) { s.lighting = false; });
  expect_fast([](Settings& s) { s.specular = false; });
  expect_fast([](Settings& s) { s.shadows = Shadows::none; });
  expect_fast([](Settings& s) { s.shadow_any_hit = false; });
  expect_fast([](Settings& s) { s.shadow_rays = ShadowRays::useful; });
  expect_fast([](Settings& s) {
    s.shadow_rays = ShadowRays::useful;
    s.specular = false;
  });
  expect_fast([](Settings& s) { s.reflection_depth = 0; });
  expect_fast([](Settings& s) { s.reflection_depth = 64; });
  for (const double cutoff : {0.01, 0.1, 0.2, 0.5, 1.0})
    expect_fast([&](Settings& s) {
      s.reflection_depth = 64;
      s.reflection_cutoff = cutoff;
    });
  expect_fast([](Settings& s) { s.accelerator = Accelerator::none; });
  expect_fast([](Settings& s) { s.sample_position = SamplePosition::corner; });
  expect_fast([](Settings& s) { s.near = 3; });
  expect_fast([](Settings& s) { s.far = 3.5; });
  expect_fast([](Settings& s) { s.field_of_view_span = FieldOfViewSpan::centres; });
}

TEST(Packets, ScenesWithTintsHugeExponentsAndNoObjects) {
  std::mt19937 random(62);
  for (int i = 0; i < test::trials(40); ++i) {
    Scene scene = load_scene("cgfs/reflections");
    scene.materials.edit([&](std::vector<Material>& materials) {
      for (Material& material : materials) {
        material.colour = {between(random, 0, 1), between(random, 0, 1), between(random, 0, 1)};
        material.specular = std::exp(between(random, -3, 12));
        material.reflective = between(random, -0.2, 1.2);
      }
    });
    scene.lights.edit([&](std::vector<Light>& lights) {
      for (Light& light : lights) {
        light.colour = {between(random, 0, 1), between(random, 0, 1), between(random, 0, 1)};
        light.position = {between(random, -4, 4), between(random, -1.1, 3), between(random, 0, 6)};
      }
    });
    scene.geometry.edit([&](Geometry& geometry) {
      geometry.objects.resize(random() % 5);
      for (int k = static_cast<int>(random() % 4); k > 0; --k)
        geometry.objects.push_back({"more", Sphere{{between(random, -2, 2), between(random, -1, 1), 3}, 0.6, 0}});
    });
    const View view{scene.camera, 67, 45};
    EXPECT_TRUE(takes_the_fast_path(scene, view, {}));
    expect_same_on_all_targets(scene, view, {});
  }
}

TEST(Packets, WhatTheyDoNotCoverIsLeftToTheClearPath) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 40, 30};
  Settings settings;
  settings.self_hit = SelfHit::epsilon;
  EXPECT_FALSE(takes_the_fast_path(scene, view, settings));
  for (unsigned seed = 71; seed < 75; ++seed) {
    const Scene other = test::random_scene(seed);
    expect_same_on_all_targets(other, View{other.camera, 40, 30}, {});
  }
}

/// Subsampling: the same pixels reuse what their neighbours saw, so the same thin things are missed.
TEST(Packets, SubsamplingReusesTheSame) {
  for (const char* name : {"cgfs/reflections", "cgfs/fence", "cgfs/mirrors", "octree/headline", "cgfs/shading"}) {
    const Scene scene = load_scene(name);
    for (const int step : {2, 3, 8, 16}) {
      SCOPED_TRACE(std::string(name) + ", step " + std::to_string(step));
      Settings settings;
      settings.subsampling = step;
      settings.shadow_cache = step == 3;
      const View view{scene.camera, 75, 49};
      if (std::string_view(name) == "cgfs/reflections" && step != 3) {
        EXPECT_TRUE(takes_the_fast_path(scene, view, settings));
      }
      expect_same_on_all_targets(scene, view, settings);
    }
  }
}

/// What it is for: fewer tests, with and without SIMD, for the same picture where nothing is thinner than the step.
TEST(Packets, SubsamplingSavesTests) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings;
  settings.reflection_depth = 0;
  settings.shadows = Shadows::none;
  Prepared prepared;
  for (const Simd simd : {Simd::off, Simd::automatic}) {
    settings.subsampling = 1;
    const Frame plain = traced(scene, View{scene.camera, 320, 320}, settings, simd, prepared);
    settings.subsampling = 8;
    const Frame less = traced(scene, View{scene.camera, 320, 320}, settings, simd, prepared);
    EXPECT_LT(less.counters[Counter::sphere_tests] * 2, plain.counters[Counter::sphere_tests]);
    EXPECT_GT(less.counters[Counter::searches_saved], 320u * 320 * 3 / 4);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < plain.colour.pixels().size(); ++i)
      differing += plain.colour.pixels()[i] != less.colour.pixels()[i] ? 1 : 0;
    EXPECT_LT(differing, 320u * 320 / 100);
  }
}

TEST(Packets, SeveralSamplesForEachPixel) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 37, 21};  // no multiple of any number of lanes
  for (const SamplePattern pattern :
       {SamplePattern::grid, SamplePattern::jitter, SamplePattern::random, SamplePattern::halton, SamplePattern::r2})
    for (const int count : {1, 3, 16, test::trials(300)})
      for (const bool adaptive : {false, true}) {
        SCOPED_TRACE(count);
        Settings settings;
        settings.samples_per_pixel = count;
        settings.sample_pattern = pattern;
        settings.adaptive_sampling = adaptive;
        settings.sample_position = adaptive ? SamplePosition::corner : SamplePosition::centre;
        ASSERT_TRUE(takes_the_fast_path(scene, view, settings));
        expect_same_on_all_targets(scene, view, settings);
      }
}

}  // namespace
}  // namespace packet_property_test
