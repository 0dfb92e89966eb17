// Precision maps and differences by cause against pictures compared here.
#include "study/precision_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "frame/display_frame.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "study/difference_by_cause.h"

namespace ps::precision_map_test {
namespace {

PrecisionMap map_of(const Scene& scene, const Settings& settings, int side = 100) {
  Prepared prepared;
  Progress progress;
  return precision_map(scene, {scene.camera, side, side}, settings, prepared, progress);
}

TEST(PrecisionMap, CountsEveryPixelOnce) {
  const Scene scene = load_scene("cgfs/reflections");
  const PrecisionMap map = map_of(scene, settings_for(scene));
  EXPECT_EQ(std::accumulate(map.counts.begin(), map.counts.end(), std::uint64_t{0}), 10000u);
  EXPECT_GT(map.count(PrecisionFault::none), 9990u) << "the defaults";
}

TEST(PrecisionMap, ABallFarAwayIsMissedAndSeenWhereItIsNot) {
  // 4,100 radii away the textbook discriminant in float is wrong for two rays of five (Ray Tracing Gems 7).
  const Scene scene = parse_scene(
      "viewport_size = 1 x 1\nprojection_plane_d = 1366\nsphere { center = (0, 0, 4100) radius = 1 color = red }\n"
      "light { type = ambient intensity = 1 }\n",
      "far ball", ".");
  Settings settings;
  settings.near = 0;
  const PrecisionMap robust = map_of(scene, settings);
  EXPECT_GE(robust.count(PrecisionFault::none), 9995u) << "a ray or two may pass the outline within a rounding";
  settings.sphere_test = SphereTest::quadratic;
  const PrecisionMap naive = map_of(scene, settings);
  EXPECT_GT(naive.count(PrecisionFault::false_hit) + naive.count(PrecisionFault::missed_hit), 800u);
  EXPECT_EQ(naive.count(PrecisionFault::wrong_winner), 0u);
}

/// Two sheets across the whole picture, the second one `gap` behind the first at `z`.
Scene sheets(double z, double gap) {
  const double size = 2 * z;
  const auto sheet = [&](double at, const char* colour) {
    return "rectangle { corner = (" + std::to_string(-size / 2) + ", " + std::to_string(-size / 2) + ", " +
           std::to_string(at) + ") side_a = (" + std::to_string(size) + ", 0, 0) side_b = (0, " + std::to_string(size) +
           ", 0) color = " + colour + " }\n";
  };
  return parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\n" + sheet(z, "red") + sheet(z + gap, "blue"),
                     "sheets", ".");
}

TEST(PrecisionMap, TheGapIsInUnitsOfTheStoredDepth) {
  Settings settings{.renderer = Renderer::rasterizer};
  settings.near = 0.1;
  settings.far = 10000;
  settings.lighting = false;
  settings.depth_format = DepthFormat::unorm;
  for (const double gap : {0.125, 0.5, 4.0}) {
    const PrecisionMap map = map_of(sheets(100, gap), settings, 20);
    // A unit of 24 bits is z^2 / (near 2^24) wide at z.
    const double expected = gap * 0.1 * 16777216 / (100 * (100 + gap));
    EXPECT_NEAR(map.gap.at(10, 10), expected, 1.01) << gap;
  }
  settings.depth_bits = 16;
  EXPECT_LT(map_of(sheets(1000, 0.125), settings, 20).gap.at(10, 10), 1) << "16 bits cannot tell them apart";
  EXPECT_TRUE(std::isinf(map_of(load_scene("cgfs/triangles"), Settings{}, 20).gap.at(0, 0))) << "nothing behind";
}

TEST(PrecisionMap, FightingSheetsHaveWrongWinners) {
  const Scene scene = load_scene("lab/z-fighting");
  const PrecisionMap map = map_of(scene, settings_for(scene));
  std::uint64_t confused = 0;
  for (const float gap : map.gap.pixels()) confused += gap < 1 ? 1 : 0;
  EXPECT_GT(confused, 500u);
  // Where one value stands for both, the first one drawn wins; that is the farther sheet in each pair.
  EXPECT_GT(map.count(PrecisionFault::wrong_winner), 500u);
}

DifferenceByCause causes_of(const Scene& scene, const Settings& a, const Settings& b,
                            ErrorMetric metric = ErrorMetric::rmse) {
  CauseRequest request;
  request.scene = scene;
  request.view = {scene.camera, 60, 60};
  request.a = a;
  request.b = b;
  request.error.metric = metric;
  request.orders = 4;
  StudyControl control;
  return difference_by_cause(request, control);
}

const CauseShare& find(const DifferenceByCause& result, std::string_view option) {
  for (const CauseShare& cause : result.causes)
    if (cause.option == option) return cause;
  ADD_FAILURE() << option;
  return result.causes.front();
}

TEST(DifferenceByCause, SharesAddUpToTheWhole) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings a, b;
  b.reflection_depth = 0;
  b.shadows = Shadows::none;
  b.specular = false;
  b.threads = 1;
  for (const ErrorMetric metric : {ErrorMetric::rmse, ErrorMetric::mae, ErrorMetric::ssim, ErrorMetric::flip}) {
    const DifferenceByCause result = causes_of(scene, a, b, metric);
    ASSERT_EQ(result.causes.size(), 4u);
    double sum = 0;
    for (const CauseShare& cause : result.causes) sum += cause.share;
    EXPECT_NEAR(sum, result.total, 1e-9 * std::max(1.0, result.total));
    EXPECT_GT(result.total, 0);
    EXPECT_EQ(find(result, "threads").note, "only speed changes");
    EXPECT_TRUE(result.every_order);
  }
  // From pictures made here: what the mirrors alone change.
  const DifferenceByCause result = causes_of(scene, a, b);
  Settings only = a;
  only.reflection_depth = 0;
  const View view{scene.camera, 60, 60};
  const auto levels = [&](const Settings& s) { return display_frame(render(scene, view, s), s); };
  EXPECT_NEAR(find(result, "reflection-depth").alone, compare_images(levels(a), levels(only)).rmse, 1e-9);
}

TEST(DifferenceByCause, TwoOptionsShareAsTheMeanOfBothOrders) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings a, b;
  b.shadows = Shadows::none;
  b.reflection_depth = 0;
  const DifferenceByCause result = causes_of(scene, a, b);
  const CauseShare &shadows = find(result, "shadows"), &mirrors = find(result, "reflection-depth");
  EXPECT_NEAR(shadows.share, (shadows.alone + result.total - mirrors.alone) / 2, 1e-9);
  EXPECT_NEAR(mirrors.without, shadows.alone, 1e-9);
}

TEST(DifferenceByCause, AnOptionWithoutEffectHasNoShareInAnyOrder) {
  const Scene scene = load_scene("cgfs/reflections");  // no texture, no triangle
  Settings a, b;
  b.textures = false;
  b.interpolation = Interpolation::affine;
  b.normals = Normals::triangle;
  b.texture_wrap = TextureWrap::clamp;
  b.triangle_test = TriangleTest::barycentric;
  b.mip_bias = 1;
  b.reflection_depth = 1;
  const DifferenceByCause result = causes_of(scene, a, b);
  EXPECT_FALSE(result.every_order) << "seven options";
  EXPECT_EQ(result.causes.front().option, "reflection-depth");
  EXPECT_NEAR(result.causes.front().share, result.total, 1e-9);
  for (std::size_t i = 1; i < result.causes.size(); ++i)
    EXPECT_EQ(result.causes[i].share, 0) << result.causes[i].option;
}

}  // namespace
}  // namespace ps::precision_map_test
