// Which pictures shade the hits of eight eye rays together.
#include <gtest/gtest.h>

#include "options/option.h"
#include "raytrace/fast/shade_hits.h"
#include "raytrace/renderer.h"
#include "scene/load.h"
#include "support/settings_with.h"

namespace ps::shade_hits_test {
namespace {

bool by_eight(const Scene& scene, const Settings& settings) {
  Prepared prepared;
  return hit_tables(make_trace_inputs<float>(scene, View{scene.camera, 61, 43}, settings, prepared,
                                             Channel::ids | Channel::depth))
      .has_value();
}

TEST(ShadeHits, AreLeftAloneWhereTheirTablesSayTooLittle) {
  if (hit_functions(Simd::automatic).light == nullptr) GTEST_SKIP() << "the processor has no eight lanes";
  const Scene scene = load_scene("cgfs/shading");
  EXPECT_TRUE(by_eight(scene, {})) << "or what follows says nothing";
  EXPECT_TRUE(by_eight(scene, settings_with({}, {"accelerator=two-level"})));
  EXPECT_FALSE(by_eight(scene, settings_with({}, {"simd=off"})));
  EXPECT_FALSE(by_eight(scene, settings_with({}, {"simd=sse4"})));
  EXPECT_FALSE(by_eight(scene, settings_with({}, {"illumination=radiometric"})));
  EXPECT_FALSE(by_eight(scene, settings_with({}, {"shadow-cache=on"})));
  EXPECT_FALSE(by_eight(load_scene("cgfs/crates"), {})) << "all that it has is textured";
  EXPECT_FALSE(by_eight(load_scene("cgfs/reflections"), {})) << "it has no triangles";
}

}  // namespace
}  // namespace ps::shade_hits_test
