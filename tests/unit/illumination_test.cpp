// The illumination equation against values worked out by hand from CGFS ch. 3.
#include "shade/illumination.h"

#include <gtest/gtest.h>

namespace ps::illumination_test {
namespace {

const auto nothing_blocks = [](int, const Vec3d&, double) -> std::optional<PixelId> { return {}; };

ShadingLight<double> light(LightKind kind, double intensity, Vec3d vector) {
  return {kind, intensity, {1, 1, 1}, vector};
}

Lighting<double> lit(const LitPoint<double>& point, const ShadingMaterial<double>& material,
                     std::vector<ShadingLight<double>> lights, const IlluminationOptions& options = {}) {
  Silent silent;
  return illuminate<double>(point, material, lights, options, nothing_blocks, silent);
}

TEST(Illumination, LightUnderSixtyDegreesGivesHalf) {
  const LitPoint<double> point{{0, 0, 0}, {0, 0, 2}, {1, 0, 0}};
  const Vec3d direction{std::sqrt(3.0), 0, 1};  // not of length 1, on purpose
  const auto result = lit(point, {}, {light(LightKind::directional, 0.6, direction)});
  EXPECT_NEAR(result.light.x, 0.3, 1e-15);
  EXPECT_EQ(result.light.x, result.light.z);
}

TEST(Illumination, PointLightDoesNotFadeWithDistance) {
  const LitPoint<double> point{{1, 2, 3}, {0, 1, 0}, {0, 1, 0}};
  for (const double height : {0.1, 1.0, 1000.0})
    EXPECT_DOUBLE_EQ(lit(point, {}, {light(LightKind::point, 0.6, {1, 2 + height, 3})}).light.y, 0.6);
}

TEST(Illumination, AmbientNeedsNoDirection) {
  EXPECT_EQ(lit({}, {}, {light(LightKind::ambient, 0.2, {})}).light.x, 0.2);
}

TEST(Illumination, LightFromBehindGivesNothing) {
  EXPECT_EQ(lit({{0, 0, 0}, {0, 0, 1}, {0, 0, 1}}, {}, {light(LightKind::directional, 1, {0, 0, -1})}).light.x, 0);
}

TEST(Illumination, HighlightFallsWithThePowerOfTheCosine) {
  ShadingMaterial<double> shiny;
  shiny.specular = 10;
  const double angle = 0.3;  // between the mirrored light and the viewer
  const LitPoint<double> point{{0, 0, 0}, {0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}};
  const auto light_above = light(LightKind::directional, 0.5, {0, 0, 4});
  EXPECT_NEAR(lit(point, shiny, {light_above}).light.x, 0.5 + 0.5 * std::pow(std::cos(angle), 10), 1e-14);
  EXPECT_NEAR(lit(point, shiny, {light_above}, {true, Highlight::blinn_phong}).light.x,
              0.5 + 0.5 * std::pow(std::cos(angle / 2), 10), 1e-14);
  EXPECT_DOUBLE_EQ(lit(point, shiny, {light_above}, {false, Highlight::phong}).light.x, 0.5);
}

TEST(Illumination, BlockedLightGivesNeitherTermAndNamesItsBlocker) {
  ShadingMaterial<double> shiny;
  shiny.specular = 10;
  const std::vector lights{light(LightKind::ambient, 0.2, {}), light(LightKind::point, 0.8, {0, 0, 5})};
  const PixelId blocker{3, 0};
  const auto blocks = [&](int index, const Vec3d& to_light, double t_max) -> std::optional<PixelId> {
    EXPECT_EQ(index, 1);
    EXPECT_EQ(to_light, (Vec3d{0, 0, 5}));
    EXPECT_EQ(t_max, 1);
    return blocker;
  };
  PixelRecorder recorder({0, 0});
  const auto result = illuminate<double>({}, shiny, lights, {}, blocks, recorder);
  EXPECT_EQ(result.light.x, 0.2);
  EXPECT_EQ(recorder.counters[Counter::light_samples], 2u);
  const auto events = recorder.take();
  ASSERT_EQ(events.size(), 2u);
  const auto& event = std::get<LightEvent>(events[1].data);
  EXPECT_EQ(event.blocker, blocker);
  EXPECT_EQ(event.diffuse, 0);
  EXPECT_EQ(event.n_dot_l, 1);
}

// CGFS ch. 13's own program can leave out either term; ambient light stays.
TEST(Illumination, WithoutTheDiffuseTermHighlightsStay) {
  ShadingMaterial<double> shiny;
  shiny.specular = 10;
  const double angle = 0.3;
  const LitPoint<double> point{{0, 0, 0}, {0, 0, 1}, {std::sin(angle), 0, std::cos(angle)}};
  const std::vector lights{light(LightKind::ambient, 0.2, {}), light(LightKind::directional, 0.5, {0, 0, 4})};
  IlluminationOptions options;
  options.diffuse = false;
  EXPECT_NEAR(lit(point, shiny, lights, options).light.x, 0.2 + 0.5 * std::pow(std::cos(angle), 10), 1e-14);
  EXPECT_EQ(lit(point, {}, lights, options).light.x, 0.2) << "matte";
  EXPECT_TRUE(adds_light(point, shiny, Vec3d{0, 0, 4}, options));
  EXPECT_FALSE(adds_light(point, ShadingMaterial<double>{}, Vec3d{0, 0, 4}, options)) << "nothing is left of it";
}

TEST(Illumination, ColoursOfTheirOwnGoIntoExtra) {
  ShadingMaterial<double> plastic;
  plastic.specular = 10;
  plastic.specular_colour = Vec3d{1, 1, 1};
  plastic.ambient_colour = Vec3d{0, 0, 0.5};
  const std::vector lights{light(LightKind::ambient, 0.2, {}), light(LightKind::directional, 0.5, {0, 0, 1})};
  const auto result = lit({}, plastic, lights);
  EXPECT_EQ(result.light, (Vec3d{0.5, 0.5, 0.5}));
  EXPECT_EQ(result.extra, (Vec3d{0.5, 0.5, 0.5 + 0.1}));
}

}  // namespace
}  // namespace ps::illumination_test
