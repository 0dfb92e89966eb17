// Depth buffers of few bits against depths in double precision, and against the measured rates of the stability tables
// (2.7: near 0.1, far 10000).
#include <gtest/gtest.h>

#include <random>

#include "options/option.h"
#include "options/scene_settings.h"
#include "raster/setup/depth_format.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::depth_format_test {
namespace {

using raster::DepthCode;

constexpr unsigned seed = 20261121;

DepthCode code(DepthFormat format, int bits = 24, bool reversed = false, DepthValue value = DepthValue::inverse_z) {
  DepthCode code;
  code.value = value;
  code.format = format;
  code.bits = bits;
  code.reversed = reversed;
  code.near = 0.1;
  code.far = 10000;
  return code;
}

float encoded(const DepthCode& how, double z) {
  return how.encode(how.value == DepthValue::inverse_z ? static_cast<float>(1 / z) : static_cast<float>(z));
}

/// Share of pairs with this gap about z that the buffer does not tell apart.
double confused(const DepthCode& how, double z, double gap) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> near_z(z * 0.95, z * 1.05);
  constexpr int pairs = 4000;
  int wrong = 0;
  for (int i = 0; i < pairs; ++i) {
    const double front = near_z(random);
    wrong += !raster::is_nearer(how, encoded(how, front), encoded(how, front + gap));
  }
  return static_cast<double>(wrong) / pairs;
}

/// The smallest gap at z that 99 % of pairs show.
double smallest_gap(const DepthCode& how, double z) {
  double low = z * 1e-9, high = z * 10;
  for (int i = 0; i < 40; ++i) {
    const double middle = std::sqrt(low * high);
    (confused(how, z, middle) > 0.01 ? low : high) = middle;
  }
  return high;
}

TEST(DepthFormat, ResolvesTheGapsThatWereMeasured) {
  struct Row {
    const char* name;
    DepthCode code;
    std::array<double, 4> gap;  // at z = 1, 10, 100, 1000
  };
  const std::vector<Row> rows{
      {"16 bits", code(DepthFormat::unorm, 16), {1.7e-4, .016, 1.7, 68 * 3}},
      {"24 bits", code(DepthFormat::unorm, 24), {6.2e-7, 6.7e-5, .0062, .67}},
      {"24 bits, reversed", code(DepthFormat::unorm, 24, true), {6.2e-7, 6.7e-5, .0062, .67}},
      {"float", code(DepthFormat::unit_float), {6.2e-7, 6.7e-5, .0062, .67}},
      {"float, reversed", code(DepthFormat::unit_float, 24, true), {1.3e-7, 1e-6, 1.5e-5, 1.3e-4}},
      {"1 / z", code(DepthFormat::plain), {1.3e-7, 1e-6, 1.5e-5, 1.3e-4}},
      {"24 bits of z", code(DepthFormat::unorm, 24, false, DepthValue::z), {6.7e-4, 6.2e-4, 6.7e-4, 6.2e-4}}};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < 4; ++i) {
      const double z = std::pow(10.0, static_cast<double>(i));
      const double gap = smallest_gap(row.code, z);
      // The tables are given to two digits, and ulps jump by two: within a factor of two.
      EXPECT_GT(gap, row.gap[i] / 2) << row.name << " at " << z << ", seed " << seed;
      EXPECT_LT(gap, row.gap[i] * 2) << row.name << " at " << z << ", seed " << seed;
    }
}

TEST(DepthFormat, ConfusesAsManyPairsAsWereMeasured) {
  const auto percent = [](const DepthCode& how, double gap) { return 100 * confused(how, 1000, gap); };
  const std::array<double, 3> gap{.001, .01, .1}, bits24{99.8, 98.3, 82.4}, bits16{100, 100, 99.9};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(percent(code(DepthFormat::unorm, 24), gap[i]), bits24[i], 4) << gap[i];
    EXPECT_NEAR(percent(code(DepthFormat::unit_float), gap[i]), bits24[i], 4) << gap[i];
    EXPECT_NEAR(percent(code(DepthFormat::unorm, 16), gap[i]), bits16[i], 1) << gap[i];
    EXPECT_EQ(percent(code(DepthFormat::unit_float, 24, true), gap[i]), 0) << gap[i];
  }
}

TEST(DepthFormat, KeepsOrderAndLimits) {
  for (const bool reversed : {false, true})
    for (const DepthFormat format : {DepthFormat::unit_float, DepthFormat::unorm})
      for (const DepthValue value : {DepthValue::inverse_z, DepthValue::z}) {
        const DepthCode how = code(format, 8, reversed, value);
        const float top = format == DepthFormat::unorm ? 255.0f : 1.0f;
        EXPECT_NEAR(encoded(how, 0.1), reversed ? top : 0, 1e-6);
        EXPECT_EQ(encoded(how, 10000), reversed ? 0 : top);
        EXPECT_EQ(encoded(how, 0.05), reversed ? top : 0);
        EXPECT_FALSE(raster::is_nearer(how, encoded(how, 7), encoded(how, 7)));
        EXPECT_TRUE(raster::is_nearer(how, encoded(how, 0.15), encoded(how, 9000)));
        EXPECT_TRUE(raster::is_nearer(how, encoded(how, 10000), raster::empty_depth<float>(how)));
      }
}

/// Pixels of the scene that show another triangle than depths in double do.
int fighting(const std::vector<std::string>& assignments) {
  const Scene scene = load_scene("lab/z-fighting");
  const View view{scene.camera, 300, 300};
  const auto draw = [&](Settings settings) { return render(scene, view, settings, request_for(Channel::ids)); };
  Settings truth = settings_for(scene);
  truth.precision = Precision::float64;
  truth.depth_format = DepthFormat::plain;
  const Frame expected = draw(truth);
  Settings settings = settings_with(settings_for(scene), assignments);
  const Frame frame = draw(settings);
  int wrong = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x) wrong += frame.ids.at(x, y) != expected.ids.at(x, y);
  return wrong;
}

TEST(ZFighting, IsCuredByBitsOrByReversing) {
  const int bits8 = fighting({"depth-bits=8"}), bits16 = fighting({"depth-bits=16"}),
            bits24 = fighting({"depth-bits=24"});
  EXPECT_GT(bits16, 5000);  // all three sheets, of about 40,000 pixels
  EXPECT_GE(bits8, bits16);
  EXPECT_GT(bits24, 1000);  // the farthest one is left
  EXPECT_LT(bits24, bits16 / 2);
  EXPECT_NEAR(fighting({"depth-bits=24", "depth-reversed=on"}), bits24, bits24 / 5.0);
  EXPECT_GT(fighting({"depth-format=unit-float"}), 1000);
  EXPECT_EQ(fighting({"depth-format=unit-float", "depth-reversed=on"}), 0);
  EXPECT_EQ(fighting({"depth-format=plain"}), 0);
  EXPECT_EQ(fighting({"depth-bits=24", "depth-value=z"}), 0);  // 24 bits of z have steps of 0.0006 everywhere
}

TEST(ZFighting, InspectorShowsTheStoredSteps) {
  const Scene scene = load_scene("lab/z-fighting");
  Settings settings = settings_for(scene);
  settings.depth_bits = 8;
  const PixelStory story = inspect(scene, {scene.camera, 600, 600}, settings, scene.start_pixel);
  int failed = 0;
  for (const auto* fragment : events_of<FragmentEvent>(story.events)) {
    EXPECT_EQ(fragment->depth_new, 255);  // round(255 (1 - 0.1 / 1000) / (1 - 0.1 / 10000))
    failed += fragment->depth == FragmentEvent::Depth::failed;
  }
  EXPECT_EQ(failed, 1);  // the orange sheet, drawn later, is not nearer
}

}  // namespace
}  // namespace ps::depth_format_test
