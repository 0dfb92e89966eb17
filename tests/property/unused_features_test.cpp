// A scene without a feature executes none of its code: what it cannot use is not even counted once.
#include <gtest/gtest.h>

#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace {

using namespace ps;

class UnusedFeatures : public testing::TestWithParam<Renderer> {};

TEST_P(UnusedFeatures, OfABuiltinSceneCostNothing) {
  int without_something = 0;
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
      for (const Counter counter : unused) EXPECT_EQ(counters[counter], 0u) << what << ": " << counter_key(counter);
    };
    const bool rays = GetParam() == Renderer::ray_tracer;
    expect_none(!traits.reflective && !traits.transparent, "no mirror",
                {Counter::reflection_rays, Counter::environment_reads});
    expect_none(!traits.transparent, "nothing transparent", {Counter::refraction_rays});
    expect_none(!traits.casting_lights, "no light that casts",
                {Counter::shadow_rays, Counter::shadow_map_taps, Counter::silhouette_edges, Counter::stencil_tests,
                 Counter::stencil_updates});
    expect_none(scene.lights->empty(), "no light", {Counter::light_samples});
    expect_none(!traits.textures && !traits.normal_maps, "no texture", {Counter::texel_reads});
    expect_none(rays && !traits.spheres, "no sphere", {Counter::sphere_tests});
    expect_none(rays && !traits.triangles, "no triangle", {Counter::triangle_tests, Counter::edge_rays});
    expect_none(!traits.solids && !traits.csg, "no solid", {Counter::solid_tests});
    expect_none(!traits.spheres && !traits.triangles && !traits.solids && !traits.canvas_items, "nothing to draw",
                {Counter::fragments, Counter::coverage_tests, Counter::depth_tests});
    expect_none(settings.samples_per_pixel == 1, "one sample", {Counter::pixels_subdivided});
    // Each renderer leaves the other's work alone.
    if (rays)
      expect_none(true, "rays",
                  {Counter::fragments, Counter::coverage_tests, Counter::depth_tests, Counter::triangles_in});
    else
      expect_none(true, "fragments",
                  {Counter::eye_rays, Counter::shadow_rays, Counter::sphere_tests, Counter::node_visits});
  }
  EXPECT_GT(without_something, 100);
}

INSTANTIATE_TEST_SUITE_P(BothRenderers, UnusedFeatures, testing::Values(Renderer::ray_tracer, Renderer::rasterizer),
                         [](const auto& of) {
                           return of.param == Renderer::ray_tracer ? std::string("Rays") : std::string("Fragments");
                         });

}  // namespace
