// Light in watts (CGPP 15.4.5 to 7) against integrals, and attenuation against its formula.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>

#include "shade/illumination.h"
#include "support/trials.h"

namespace ps::radiometric_test {
namespace {
using std::numbers::pi;
const auto nothing_blocks = [](int, const Vec3d&, double) -> std::optional<PixelId> { return {}; };

Lighting<double> lit(const LitPoint<double>& point, const ShadingMaterial<double>& material,
                     const ShadingLight<double>& light, const IlluminationOptions& options) {
  Silent silent;
  const std::vector<ShadingLight<double>> lights{light};
  return illuminate<double>(point, material, lights, options, nothing_blocks, silent);
}

IlluminationOptions radiometric() {
  IlluminationOptions options;
  options.illumination = Illumination::radiometric;
  options.highlight = Highlight::blinn_phong;
  return options;
}

ShadingLight<double> light(LightKind kind, double intensity, const Vec3d& vector) {
  ShadingLight<double> result;
  result.kind = kind;
  result.intensity = intensity;
  result.vector = vector;
  return result;
}

TEST(Radiometric, PointLightFadesWithTheSquareOfDistance) {
  const LitPoint<double> point{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  for (const double height : {0.5, 2.0, 100.0}) {
    const double got = lit(point, {}, light(LightKind::point, 10, {0, 0, height}), radiometric()).light.x;
    EXPECT_NEAR(got, 10 / (4 * pi * height * height) / pi, 1e-12 * got);
  }
}

/// Sum over the hemisphere, in directions weighted by their solid angle.
template <class Value>
double over_hemisphere(Value value) {
  constexpr int rings = 800, sectors = 400;
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double polar = (i + 0.5) / rings * pi / 2;
    for (int k = 0; k < sectors; ++k) {
      const double around = (k + 0.5) / sectors * 2 * pi;
      const Vec3d direction{std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)};
      sum += value(direction) * std::sin(polar) * (pi / 2 / rings) * (2 * pi / sectors);
    }
  }
  return sum;
}

// In a white furnace, radiance 1 from everywhere, a white Lambert surface is as bright as the furnace.
TEST(Radiometric, WhiteFurnaceOfLambert) {
  const LitPoint<double> point{{0, 0, 0}, {0, 0, 1}, {0.3, 0.2, 1}};
  const double sum = over_hemisphere([&](const Vec3d& direction) {
    return lit(point, {}, light(LightKind::directional, 1, direction), radiometric()).light.z;
  });
  EXPECT_NEAR(sum, 1, 1e-5);
  IlluminationOptions book = radiometric();
  book.illumination = Illumination::book;
  const double unscaled = over_hemisphere([&](const Vec3d& direction) {
    return lit(point, {}, light(LightKind::directional, 1, direction), book).light.z;
  });
  EXPECT_NEAR(unscaled, pi, 1e-4) << "the book's light is not energy";
}

// Seen along the normal, a highlight of strength 1 sends back about 1 of what a furnace sends, whatever its exponent;
// (s + 8) / 8 pi is Hoffman and Sloan's fit, 7 % too much at worst and exact in the limit of sharp highlights.
TEST(Radiometric, BlinnPhongIsNormalised) {
  const LitPoint<double> point{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  const auto reflected = [&](double exponent) {
    ShadingMaterial<double> material;
    material.specular = exponent;
    material.specular_colour = Vec3d(1);
    return over_hemisphere([&](const Vec3d& direction) {
      return lit(point, material, light(LightKind::directional, 1, direction), radiometric()).extra.x;
    });
  };
  // Closed form of the integral: with half angle a, cos(theta) = 2 cos^2 a - 1 and d omega = 4 cos a d omega_h.
  const auto expected = [](double s) {
    double sum = 0;
    constexpr int steps = test::trials(200000);
    for (int i = 0; i < steps; ++i) {
      const double a = (i + 0.5) / steps * pi / 4, c = std::cos(a);
      sum += std::pow(c, s) * (2 * c * c - 1) * 4 * c * 2 * pi * std::sin(a) * (pi / 4 / steps);
    }
    return (s + 8) / (8 * pi) * sum;
  };
  for (const double exponent : {1.0, 10.0, 100.0, 1000.0}) {
    const double got = reflected(exponent);
    EXPECT_NEAR(got, expected(exponent), 2e-3 * got) << exponent;
    EXPECT_LE(got, 1.08) << exponent;
  }
  EXPECT_NEAR(reflected(1000), 1, 0.01);
}

TEST(Radiometric, NoHighlightFromBehind) {
  const LitPoint<double> point{{0, 0, 0}, {0, 0, 1}, {1, 0, 0.05}};
  ShadingMaterial<double> material;
  material.specular = 2;
  EXPECT_EQ(lit(point, material, light(LightKind::directional, 1, {1, 0, -0.01}), radiometric()).light.x, 0);
}

TEST(Attenuation, DividesByItsPolynomial) {
  const LitPoint<double> point{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  ShadingLight<double> lamp = light(LightKind::point, 0.8, {0, 0, 3});
  lamp.attenuation = {0.5, 0.25, 0.125};
  lamp.attenuates = true;
  EXPECT_DOUBLE_EQ(lit(point, {}, lamp, {}).light.x, 0.8 / (0.5 + 0.75 + 1.125));
  IlluminationOptions off;
  off.attenuation = false;
  EXPECT_DOUBLE_EQ(lit(point, {}, lamp, off).light.x, 0.8);
}

}  // namespace
}  // namespace ps::radiometric_test
