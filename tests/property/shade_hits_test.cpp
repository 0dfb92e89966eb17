// Hits of eight eye rays shaded together against one after the other: the same bits, and the same work apart from the
// search.
#include <gtest/gtest.h>

#include "options/option.h"
#include "raytrace/fast/shade_hits.h"
#include "raytrace/renderer.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/same_bits.h"
#include "support/trials.h"

namespace shade_hits_test {
namespace {

using namespace ps;
using ps::test::same_bits;

constexpr Channel stored_channels = Channel::ids | Channel::depth;

Frame shaded(const Scene& scene, Settings settings, Simd simd) {
  settings.simd = simd;
  Prepared prepared;
  Progress progress;
  RenderRequest request;
  request.channels = stored_channels;
  return render_traced(scene, View{scene.camera, 61, 43}, settings, request, prepared, progress);
}

bool by_eight(const Scene& scene, const Settings& settings) {
  Prepared prepared;
  return hit_tables(make_trace_inputs<float>(scene, View{scene.camera, 61, 43}, settings, prepared, stored_channels))
      .has_value();
}

constexpr std::array work_of_shading{Counter::eye_rays,      Counter::shadow_rays,   Counter::reflection_rays,
                                     Counter::shading_calls, Counter::light_samples, Counter::pixels_written,
                                     Counter::nan_pixels};

/// `assignments` as on the command line, "shadows=none highlight=blinn-phong".
Settings with(std::initializer_list<const char*> assignments) {
  Settings settings;
  for (const char* assignment : assignments) parse_assignment(assignment, settings);
  return settings;
}

TEST(ShadeHits, GiveTheBitsOfTheClearPath) {
  if (hit_functions(Simd::automatic).light == nullptr) GTEST_SKIP() << "the processor has no eight lanes";
  std::size_t pictures = 0;
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  for (std::size_t number = 0; number < scenes.size(); number += test::list_step) {
    const BuiltinScene& entry = scenes[number];
    const Scene scene = load_scene(entry.name);
    std::size_t variant = 0;
    for (const auto& assignments : std::initializer_list<std::initializer_list<const char*>>{
             {"shadows=none"},
             {"shadows=none", "highlight=blinn-phong", "normals=triangle"},
             {"renormalise=off", "reflection-depth=0"},
             {"lighting=off"},
             {"specular=off", "self-hit=epsilon", "accelerator=octree"},
             {"shadow-rays=useful"},
             {"shadow-rays=useful", "specular=off", "highlight=blinn-phong"},
             {"shadow-any-hit=off", "adaptive-sampling=on"}}) {
      const Settings settings = with(assignments);
      SCOPED_TRACE(entry.name + std::string(" ") + *assignments.begin());
      if (variant++ % 4 != number % 4 || !by_eight(scene, settings)) continue;
      ++pictures;
      const Frame one = shaded(scene, settings, Simd::off), eight = shaded(scene, settings, Simd::automatic);
      ASSERT_TRUE(same_bits(one.colour, eight.colour));
      ASSERT_TRUE(same_bits(one.depth, eight.depth));
      ASSERT_EQ(one.ids, eight.ids);
      for (const Counter counter : work_of_shading)
        ASSERT_EQ(one.counters[counter], eight.counters[counter]) << counter_key(counter);
    }
  }
  EXPECT_GT(pictures, 20 / test::list_step) << "or this test says nothing";
}

TEST(ShadeHits, AreLeftAloneWhereTheirTablesSayTooLittle) {
  if (hit_functions(Simd::automatic).light == nullptr) GTEST_SKIP() << "the processor has no eight lanes";
  const Scene scene = load_scene("cgfs/shading");
  EXPECT_TRUE(by_eight(scene, {})) << "or what follows says nothing";
  EXPECT_FALSE(by_eight(scene, with({"simd=off"})));
  EXPECT_FALSE(by_eight(scene, with({"simd=sse4"})));
  EXPECT_FALSE(by_eight(scene, with({"illumination=radiometric"})));
  EXPECT_FALSE(by_eight(scene, with({"shadow-cache=on"})));
  EXPECT_FALSE(by_eight(scene, with({"accelerator=two-level"})));
  EXPECT_FALSE(by_eight(load_scene("cgfs/crates"), {})) << "all that it has is textured";
  EXPECT_FALSE(by_eight(load_scene("cgfs/reflections"), {})) << "it has no triangles";
}

}  // namespace
}  // namespace shade_hits_test
