// Reflection and refraction at a boundary against Fresnel's equations for both polarisations, energy, and the share of
// light that cannot leave glass (stability row 61).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shade/fresnel.h"

namespace ps::fresnel_test {
namespace {
using std::numbers::pi;

/// Mean of the reflected shares across and along the plane of incidence, by the sines and tangents of the angles: not
/// the form in which programs compute it.
double by_angles(double incident, double transmitted) {
  const double across = std::sin(incident - transmitted) / std::sin(incident + transmitted);
  const double along = std::tan(incident - transmitted) / std::tan(incident + transmitted);
  return (across * across + along * along) / 2;
}

TEST(Fresnel, AgreesWithTheFormByAnglesOnBothSides) {
  for (const double index : {1.1, 1.33, 1.5, 2.4})
    for (double degrees = 0.5; degrees < 90; degrees += 0.5) {
      const double outer = degrees * pi / 180;
      const double inner = std::asin(std::sin(outer) / index);
      const double expected = by_angles(outer, inner);
      EXPECT_NEAR(fresnel_share(std::cos(outer), std::cos(inner), 1.0, index), expected, 1e-9)
          << index << " " << degrees;
      EXPECT_NEAR(fresnel_share(std::cos(inner), std::cos(outer), index, 1.0), expected, 1e-9) << "and from inside";
    }
}

// Light that meets the boundary from within, as much from every direction of the half-space as its cosine says: what
// leaves lies within a cone of sine 1 / n, whose share is 1 / n^2.
TEST(Fresnel, OfLightInGlassFiveNinthsCannotLeave) {
  constexpr unsigned seed = 61;
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  constexpr int rays = 200'000;
  int kept = 0;
  for (int i = 0; i < rays; ++i) {
    const double sine = std::sqrt(unit()), around = 2 * pi * unit();
    const Vec3d direction{sine * std::cos(around), std::sqrt(1 - sine * sine), sine * std::sin(around)};
    const auto bent = refract(direction, Vec3d{0, 1, 0}, 1.5, 1.0);
    kept += bent ? 0 : 1;
    if (bent) {
      EXPECT_TRUE(std::isfinite(bent->direction.x + bent->direction.y + bent->direction.z));
    }
  }
  const double share = 1 - 1 / (1.5 * 1.5);
  EXPECT_NEAR(static_cast<double>(kept) / rays, share, 3 * std::sqrt(share * (1 - share) / rays)) << "seed " << seed;
}

// There and back: a ray that goes through a plate with parallel sides leaves in its first direction.
TEST(Fresnel, APlateDoesNotTurnTheRay) {
  for (double degrees = 0; degrees < 90; degrees += 1) {
    const double angle = degrees * pi / 180;
    const Vec3d direction{std::sin(angle), -std::cos(angle), 0};
    const auto inside = refract(direction, Vec3d{0, 1, 0}, 1.0, 1.5);
    ASSERT_TRUE(inside);
    const auto outside = refract(inside->direction, Vec3d{0, 1, 0}, 1.5, 1.0);
    ASSERT_TRUE(outside) << degrees;
    EXPECT_NEAR(outside->direction.x, direction.x, 1e-7);
    EXPECT_NEAR(outside->direction.y, direction.y, 1e-7);
  }
}

}  // namespace
}  // namespace ps::fresnel_test
