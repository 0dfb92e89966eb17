// Which pictures shade the hits of eight eye rays together.
#include <gtest/gtest.h>

#include "options/option.h"
#include "raytrace/fast/shade_hits.h"
#include "raytrace/renderer.h"
#include "scene/load.h"

namespace shade_hits_test {
namespace {

using namespace ps;

bool by_eight(const Scene& scene, const Settings& settings) {
  Prepared prepared;
  return hit_tables(make_trace_inputs<float>(scene, View{scene.camera, 61, 43}, settings, prepared,
                                             Channel::ids | Channel::depth))
      .has_value();
}

/// `assignments` as on the command line, "shadows=none highlight=blinn-phong".
Settings with(std::initializer_list<const char*> assignments) {
  Settings settings;
  for (const char* assignment : assignments) parse_assignment(assignment, settings);
  return settings;
}

TEST(ShadeHits, AreLeftAloneWhereTheirTablesSayTooLittle) {
  if (hit_functions(Simd::automatic).light == nullptr) GTEST_SKIP() << "the processor has no eight lanes";
  const Scene scene = load_scene("cgfs/shading");
  EXPECT_TRUE(by_eight(scene, {})) << "or what follows says nothing";
  EXPECT_TRUE(by_eight(scene, with({"accelerator=two-level"})));
  EXPECT_FALSE(by_eight(scene, with({"simd=off"})));
  EXPECT_FALSE(by_eight(scene, with({"simd=sse4"})));
  EXPECT_FALSE(by_eight(scene, with({"illumination=radiometric"})));
  EXPECT_FALSE(by_eight(scene, with({"shadow-cache=on"})));
  EXPECT_FALSE(by_eight(load_scene("cgfs/crates"), {})) << "all that it has is textured";
  EXPECT_FALSE(by_eight(load_scene("cgfs/reflections"), {})) << "it has no triangles";
}

}  // namespace
}  // namespace shade_hits_test
