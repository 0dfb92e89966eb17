// What must hold for every scene that rays see: shortcuts change nothing but the work, stories add up, and a stop is
// early.
#include <gtest/gtest.h>

#include <atomic>

#include "raytrace/renderer.h"
#include "scene/load.h"
#include "support/random_scene.h"
#include "support/same_bits.h"
#include "support/trials.h"

namespace ps::traced_property_test {
namespace {
using ps::test::random_scene;
using ps::test::same_bits;

constexpr Channel all_channels = static_cast<Channel>((1u << 12) - 1);

Frame traced(const Scene& scene, const Settings& settings, RenderRequest request = {}, int width = 97,
             int height = 61) {
  Prepared prepared;
  Progress progress;
  request.channels = all_channels;
  return render_traced(scene, View{scene.camera, width, height}, settings, request, prepared, progress);
}

enum class Tests { compare, ignore };

void expect_same(const Frame& a, const Frame& b, Tests tests) {
  EXPECT_TRUE(same_bits(a.colour, b.colour));
  EXPECT_TRUE(same_bits(a.colour_double, b.colour_double));
  EXPECT_TRUE(same_bits(a.depth, b.depth));
  EXPECT_TRUE(same_bits(a.normal, b.normal));
  EXPECT_TRUE(same_bits(a.barycentric, b.barycentric));
  EXPECT_TRUE(same_bits(a.uv, b.uv));
  EXPECT_TRUE(same_bits(a.ids, b.ids));
  EXPECT_TRUE(same_bits(a.facing, b.facing));
  EXPECT_TRUE(same_bits(a.overdraw, b.overdraw));
  EXPECT_TRUE(same_bits(a.mip, b.mip));
  EXPECT_TRUE(same_bits(a.shadow, b.shadow));
  EXPECT_TRUE(same_bits(a.samples, b.samples));
  EXPECT_TRUE(same_bits(a.direction, b.direction));
  if (tests == Tests::ignore) return;
  EXPECT_TRUE(same_bits(a.tests, b.tests));
  EXPECT_EQ(a.counters, b.counters);
}

/// The option combinations that change how rays meet surfaces.
std::vector<Settings> ways_to_intersect() {
  std::vector<Settings> ways;
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const SphereTest sphere : {SphereTest::robust, SphereTest::quadratic})
      for (const TriangleTest triangle : {TriangleTest::watertight, TriangleTest::moeller_trumbore}) {
        Settings settings;
        settings.precision = precision;
        settings.sphere_test = sphere;
        settings.triangle_test = triangle;
        settings.self_hit = sphere == SphereTest::robust ? SelfHit::offset : SelfHit::epsilon;
        ways.push_back(settings);
      }
  return ways;
}

TEST(TracedProperty, ShadowCacheCachedConstantsAndAnyHitChangeNothingButTheWork) {
  bool work_changed = false;
  for (unsigned seed = 16; seed < 16u + static_cast<unsigned>(test::trials(4)); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_scene(seed);
    for (Settings settings : ways_to_intersect()) {
      const Frame plain = traced(scene, settings);
      settings.shadow_cache = true;
      const Frame remembered = traced(scene, settings);
      expect_same(remembered, plain, Tests::ignore);
      work_changed = work_changed || !(remembered.counters == plain.counters);
      settings.shadow_cache = false;
      settings.cache_constants = false;
      expect_same(traced(scene, settings), plain, Tests::compare);
      settings.cache_constants = true;
      settings.shadow_any_hit = false;
      expect_same(traced(scene, settings), plain, Tests::ignore);
    }
  }
  EXPECT_TRUE(work_changed);
}

/// With packets of rays and without them. The picture stays nearly the same where nothing is thinner than the step.
TEST(TracedProperty, SubsamplingSavesTests) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings;
  settings.reflection_depth = 0;
  settings.shadows = Shadows::none;
  const auto picture = [&](Simd simd, int subsampling) {
    settings.simd = simd;
    settings.subsampling = subsampling;
    Prepared prepared;
    Progress progress;
    return render_traced(scene, View{scene.camera, 320, 320}, settings, {}, prepared, progress);
  };
  for (const Simd simd : {Simd::off, Simd::automatic}) {
    const Frame plain = picture(simd, 1), less = picture(simd, 8);
    EXPECT_LT(less.counters[Counter::sphere_tests] * 2, plain.counters[Counter::sphere_tests]);
    EXPECT_GT(less.counters[Counter::searches_saved], 320u * 320 * 3 / 4);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < plain.colour.pixels().size(); ++i)
      differing += plain.colour.pixels()[i] != less.colour.pixels()[i] ? 1 : 0;
    EXPECT_LT(differing, 320u * 320 / 100);
  }
}

TEST(TracedProperty, CountersOfAllStoriesAddUpToThoseOfThePicture) {
  const Scene scene = random_scene(41);
  const Frame frame = traced(scene, {}, {}, 40, 30);
  Counters sum;
  Prepared prepared;
  Progress progress;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      sum += inspect_traced(scene, View{scene.camera, 40, 30}, {}, {x, y}, prepared, progress).counters;
  for (const Counter counter : {Counter::eye_rays, Counter::shadow_rays, Counter::reflection_rays,
                                Counter::sphere_tests, Counter::triangle_tests, Counter::node_visits,
                                Counter::shading_calls, Counter::light_samples, Counter::texel_reads})
    EXPECT_EQ(sum[counter], frame.counters[counter]) << counter_key(counter);
}

TEST(TracedProperty, CancellingStopsEarlyAndThrows) {
  const Scene scene = random_scene(51);
  for (const int threads : {1, 3}) {
    Settings settings;
    settings.threads = threads;
    Prepared prepared;
    Progress progress;
    std::atomic<int> tiles{0};
    RenderRequest request;
    request.on_tile = [&](const Frame&, const TileRect&) {
      ++tiles;
      progress.request_stop();
    };
    EXPECT_THROW(render_traced(scene, View{scene.camera, 640, 640}, settings, request, prepared, progress), Cancelled);
    EXPECT_GE(tiles, 1);
    EXPECT_LE(tiles, threads) << "of 400 tiles";
  }
}

}  // namespace
}  // namespace ps::traced_property_test
