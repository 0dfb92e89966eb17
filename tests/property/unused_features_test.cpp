// A scene without a feature executes none of its code: what it cannot use is not even counted once. Asked are the
// counters that the renderer gives; that it gives no others is a test of its own.
#include <gtest/gtest.h>

#include <array>

#include "options/scene_settings.h"
#include "render/render.h"
#include "render/renderer_table.h"
#include "scene/load.h"

namespace ps::unused_features_test {
namespace {

class UnusedFeatures : public testing::TestWithParam<Renderer> {};

TEST_P(UnusedFeatures, OfABuiltinSceneCostNothing) {
  int without_something = 0, asked = 0;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    SCOPED_TRACE(builtin.name);
    const Scene scene = load_scene(builtin.name);
    const SceneTraits traits = scene_traits(scene);
    Settings settings = settings_for(scene);
    settings.renderer = GetParam();
    const Counters counters = render(scene, {scene.camera, 64, 48}, settings).counters;
    const auto expect_none = [&](bool lacks, const char* what, std::initializer_list<Counter> unused) {
      if (!lacks) return;
      ++without_something;
      for (const Counter counter : unused) {
        const auto count = counters.get(counter);
        asked += count ? 1 : 0;
        EXPECT_EQ(count.value_or(0), 0u) << what << ": " << counter_key(counter);
      }
    };
    expect_none(!traits.reflective && !traits.transparent, "no mirror",
                {Counter::reflection_rays, Counter::environment_reads});
    expect_none(!traits.transparent, "nothing transparent", {Counter::refraction_rays});
    expect_none(!traits.casting_lights, "no light that casts",
                {Counter::shadow_rays, Counter::shadow_map_taps, Counter::silhouette_edges, Counter::stencil_tests,
                 Counter::stencil_updates});
    expect_none(scene.lights->empty(), "no light", {Counter::light_samples});
    expect_none(!traits.textures && !traits.normal_maps, "no texture", {Counter::texel_reads});
    expect_none(!traits.spheres, "no sphere", {Counter::sphere_tests});
    expect_none(!traits.triangles, "no triangle", {Counter::triangle_tests, Counter::edge_rays});
    expect_none(!traits.solids && !traits.csg, "no solid", {Counter::solid_tests});
    expect_none(!traits.spheres && !traits.triangles && !traits.solids && !traits.canvas_items, "nothing to draw",
                {Counter::fragments, Counter::coverage_tests, Counter::depth_tests});
    expect_none(settings.samples_per_pixel == 1, "one sample", {Counter::pixels_subdivided});
  }
  EXPECT_GT(without_something, 100);
  EXPECT_GT(asked, 100);
}

/// Each renderer leaves the others' work alone, and gives no 0 for what it does not count.
TEST(CountersOfRenderers, AreThoseOfTheirRows) {
  const Scene scene = load_scene("cgfs/crates");
  std::array<bool, counter_count> given_by_one{};
  for (const RendererRow& row : renderer_table()) {
    Settings settings = settings_for(scene);
    settings.renderer = row.renderer;
    const Counters counters = render(scene, {scene.camera, 64, 48}, settings).counters;
    for (std::size_t i = 0; i < counter_count; ++i) {
      const auto counter = static_cast<Counter>(i);
      EXPECT_EQ(counters.get(counter).has_value(), row.counts.contains(counter)) << counter_key(counter);
      given_by_one[i] = given_by_one[i] || row.counts.contains(counter);
    }
  }
  for (std::size_t i = 0; i < counter_count; ++i)
    EXPECT_TRUE(given_by_one[i]) << counter_key(static_cast<Counter>(i)) << " is counted by no renderer";
  const auto counts = [](Renderer renderer) { return renderer_row(renderer).counts; };
  EXPECT_FALSE(counts(Renderer::ray_tracer).contains(Counter::fragments));
  EXPECT_FALSE(counts(Renderer::rasterizer).contains(Counter::eye_rays));
  EXPECT_FALSE(counts(Renderer::textbook).contains(Counter::eye_rays));
}

INSTANTIATE_TEST_SUITE_P(BothRenderers, UnusedFeatures, testing::Values(Renderer::ray_tracer, Renderer::rasterizer),
                         [](const auto& of) {
                           return of.param == Renderer::ray_tracer ? std::string("Rays") : std::string("Fragments");
                         });

}  // namespace
}  // namespace ps::unused_features_test
