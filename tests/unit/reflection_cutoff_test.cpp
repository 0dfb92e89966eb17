#include <gtest/gtest.h>

#include "inspect/describe.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::reflection_cutoff_test {
namespace {

/// The book's spheres, each of which mirrors half of the light.
Scene half_mirrors() {
  Scene scene = load_scene("cgfs/reflections");
  std::vector<Material> materials = *scene.materials;
  for (Material& material : materials) material.reflective = 0.5;
  scene.materials = Part<std::vector<Material>>(std::move(materials));
  return scene;
}

Frame traced(const Scene& scene, int depth, double cutoff, Precision precision) {
  Settings settings;
  settings.reflection_depth = depth;
  settings.reflection_cutoff = cutoff;
  settings.precision = precision;
  return render(scene, {scene.camera, 90, 90}, settings);
}

// Bounce number n brings 2^-n of the colour, so a least share and a greatest depth say the same.
TEST(ReflectionCutoff, OfHalfMirrorsIsADepth) {
  const Scene scene = half_mirrors();
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const auto& [cutoff, depth] :
         {std::pair{0.6, 0}, {0.5, 1}, {0.3, 1}, {0.25, 2}, {0.2, 2}, {0.1, 3}, {0.01, 6}}) {
      SCOPED_TRACE(cutoff);
      const Frame less = traced(scene, 20, cutoff, precision), same = traced(scene, depth, 0, precision);
      EXPECT_EQ(less.counters, same.counters);
      const auto a = less.colour.pixels(), b = same.colour.pixels();
      EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    }
}

TEST(ReflectionCutoff, IsReported) {
  const Scene scene = half_mirrors();
  Settings settings;
  settings.reflection_depth = 20;
  settings.reflection_cutoff = 0.2;
  Prepared prepared;
  int reported = 0;
  for (int y = 5; y < 90; y += 10)
    for (int x = 5; x < 90; x += 10) {
      Progress progress;
      const PixelStory story = inspect(scene, {scene.camera, 90, 90}, settings, {x, y}, prepared, progress);
      for (const Event& event : story.events)
        if (const auto* cutoff = std::get_if<CutoffEvent>(&event.data)) {
          ++reported;
          EXPECT_EQ(cutoff->share, 0.125);
          EXPECT_NEAR(cutoff->least, 0.2, 1e-7);
          EXPECT_EQ(describe(event, scene), "not followed: the next bounce would contribute 0.125 of the pixel's "
                                            "colour, less than reflection-cutoff = 0.2");
        }
    }
  EXPECT_GT(reported, 10);
}

// Glass lets all light through, so nothing is left out but branches.
TEST(ReflectionCutoff, LeavesGlassItsStrongerBranch) {
  const Scene scene = load_scene("cgfs/magnifying-glass");
  Settings settings;
  settings.transparency = TransparencyShare::fresnel;
  settings.reflection_depth = 12;
  const View view{scene.camera, 80, 60};
  const Frame all = render(scene, view, settings);
  settings.reflection_cutoff = 0.1;
  const Frame less = render(scene, view, settings);
  EXPECT_GT(all.counters[Counter::reflection_rays], 0u);
  EXPECT_LT(less.counters[Counter::reflection_rays], all.counters[Counter::reflection_rays]);
  double largest = 0;
  for (std::size_t i = 0; i < all.colour.pixels().size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      largest =
          std::max(largest, std::abs(double{all.colour.pixels()[i][axis]} - double{less.colour.pixels()[i][axis]}));
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 0.5);
}

}  // namespace
}  // namespace ps::reflection_cutoff_test
