// Stability experiments on shadow maps and shadow volumes against rates measured elsewhere and closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "support/curve.h"

namespace {

using namespace ps;
using test::Curve;

TEST(StabilityShadows, MapAcneFollowsItsFormula) {
  const Curve curve("shadow-map-acne");
  for (const int size : {256, 1024})
    for (const int elevation : {60, 30, 10}) {
      const std::string series = std::to_string(size) + " texels, sun at " + std::to_string(elevation) + " degrees";
      for (const double bias : {0.0, 0.001, 0.01, 0.05})
        EXPECT_NEAR(curve.naive(series, bias), curve.naive(series + ", by formula", bias), 1.5)
            << series << " " << bias;
      EXPECT_LT(curve.robust(series, 0), 0.1);
    }
  curve.expect_naive("1024 texels, sun at 60 degrees", 0, 50);
}

TEST(StabilityShadows, FilterWithTheBiasOfOneTap) {
  const Curve curve("pcf-one-tap-bias");
  EXPECT_LT(curve.naive("sun at 30 degrees", 1), 0.3);
  EXPECT_NEAR(curve.naive("sun at 30 degrees", 3), 100.0 / 6, 1);
  EXPECT_NEAR(curve.naive("sun at 30 degrees", 5), 30, 1);
  for (const double taps : {1.0, 3.0, 5.0, 7.0}) {
    EXPECT_LT(curve.robust("sun at 30 degrees", taps), 0.3);
    EXPECT_LE(curve.robust("sun at 30 degrees, taps on the receiver's plane", taps), 0.3);
  }
}

/// What a shadow map loses of the shadow within 0.15 of the place where a ball of radius 0.5 touches a floor, in the
/// corner of four texels: the ball itself looked up, no triangles, at places 0.003 apart.
class ContactShadow {
 public:
  ContactShadow(double texel, double elevation)
      : texel_(texel), sine_(std::sin(elevation)), cosine_(std::cos(elevation)) {}

  /// Percentage. Slope biases in texels, times the floor's slope.
  double lost(double bias, double slope_bias, int taps) const {
    const double slope = cosine_ / sine_, allowed = bias + slope_bias * texel_ * slope;
    double all = 0, lit = 0;
    for (double x = -0.1485; x < 0.15; x += 0.003)
      for (double z = -0.1485; z < 0.15; z += 0.003) {
        const double up = -z * sine_ - radius * cosine_, towards = radius * sine_ - z * cosine_;
        if (x * x + z * z > 0.15 * 0.15 || x * x + up * up > radius * radius || towards < 0) continue;
        ++all;
        const double column = std::floor(x / texel_), row = std::floor(-z * sine_ / texel_);
        for (int j = -(taps / 2); j <= taps / 2; ++j)
          for (int i = -(taps / 2); i <= taps / 2; ++i) {
            const double stored = nearest((column + i + 0.5) * texel_, (row + j + 0.5) * texel_);
            lit += stored < -z * cosine_ - allowed ? 0 : 1.0 / (taps * taps);
          }
      }
    return 100 * lit / all;
  }

 private:
  static constexpr double radius = 0.5;

  /// Depth along the sun's rays, from the place of contact, of what they meet first.
  double nearest(double across, double upwards) const {
    const double floor = upwards * cosine_ / sine_, over = upwards - radius * cosine_;
    const double square = radius * radius - across * across - over * over;
    return square > 0 ? std::min(floor, -radius * sine_ - std::sqrt(square)) : floor;
  }

  double texel_, sine_, cosine_;
};

TEST(StabilityShadows, PeterPanning) {
  const Curve curve("peter-panning", 1);
  constexpr double degree = 3.14159265358979 / 180;
  for (const auto& [size, given] :
       std::map<int, std::array<double, 3>>{{256, {9.9, 9.9, 100}}, {1024, {.8, 23.7, 20}}, {4096, {.8, 23.7, 3.3}}}) {
    const std::string series = std::to_string(size) + " texels, sun at 10 degrees";
    const std::string filtered = series + ", 5 x 5 taps with the slope of 3.5 texels";
    // 9.9, 0.8 and 23.7 are 13, 1 and 31 of 131 places: three standard deviations of so few.
    const auto few = [](double percent) { return 3 * std::sqrt(percent * (100 - percent) / 131); };
    curve.expect_robust(series, 0.2, given[0], few(curve.robust(series, 0.2)));
    curve.expect_naive(series, 0.2, given[1], few(given[1]));
    curve.expect_naive(filtered, 0, given[2], few(given[2]));
    const ContactShadow exact(8.0 / size, 10 * degree);
    // The map of the program holds triangles.
    EXPECT_NEAR(curve.robust(series, 0.2), exact.lost(0, 0.52, 1), 1.5);
    EXPECT_NEAR(curve.naive(series, 0.2), exact.lost(0.2, 0, 1), 2);
    EXPECT_NEAR(curve.naive(series, 0.05), exact.lost(0.05, 0, 1), 1.5);
    EXPECT_NEAR(curve.naive(filtered, 0), exact.lost(0, 3.5, 5), 1.5);
  }
}

TEST(StabilityShadows, CameraInsideAVolume) {
  const Curve curve("z-pass-in-volume");
  EXPECT_EQ(curve.naive("under a roof of 4 x 4", -8), 0);
  EXPECT_GT(curve.naive("under a roof of 4 x 4", 0), 99);
  curve.expect_all_robust_zero();
}

TEST(StabilityShadows, NearPlaneCutsAVolume) {
  const Curve curve("near-plane-cuts-volume");
  EXPECT_EQ(curve.naive("camera 0.05 before the shadow", 0.01), 0);
  EXPECT_GT(curve.naive("camera 0.05 before the shadow", 0.1), 99);
  curve.expect_all_robust_zero();
}

/// The sun's shadow under a roof, whose volume is a column: each of 150 x 100 lines of sight in double, no triangles.
class ColumnOnFloor {
 public:
  explicit ColumnOnFloor(const std::array<double, 3>& eye) : eye_(eye) {}

  /// What of the volume there is.
  struct Volume {
    double length = 1e6;
    bool caps = true;
    double far = 1e30;          ///< faces beyond are lost
    double floor_limit = 1e30;  ///< floor beyond is not seen
  };

  /// Percentage of the floor whose count is wrong, but for pixels beside other things or an edge of the shadow.
  double wrong(const Volume& volume) const {
    double all = 0, wrong = 0;
    for (int row = 1; row + 1 < 100; ++row)
      for (int column = 1; column + 1 < 150; ++column) {
        const Seen middle = seen(column, row);
        bool plain = middle.floor && middle.distance < volume.floor_limit;
        for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          const Seen other = seen(column + x, row + y);
          plain = plain && other.floor && other.dark == middle.dark;
        }
        if (!plain) continue;
        ++all;
        wrong += (count(column, row, middle.distance, volume) != 0) != middle.dark ? 1 : 0;
      }
    return 100 * wrong / all;
  }

 private:
  static constexpr double half = 3, top = 2.2, bottom = 2, floor_y = -1, floor_end = 25;

  struct Seen {
    bool floor = false, dark = false;
    double distance = 0;  ///< along z
  };
  struct Crossing {
    double near = -1e300, far = 1e300;
    int near_axis = 0, far_axis = 0;
  };

  std::array<double, 3> direction(int column, int row) const {
    return {((column + 0.5) / 150 - 0.5) * 1.5, 0.5 - (row + 0.5) / 100, 1};
  }
  Crossing cross(const std::array<double, 3>& along, double low_y) const {
    const std::array<double, 3> low{-half, low_y, -half}, high{half, top, half};
    Crossing crossing;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const double a = (low[i] - eye_[i]) / along[i], b = (high[i] - eye_[i]) / along[i];
      if (std::min(a, b) > crossing.near) crossing.near = std::min(a, b), crossing.near_axis = axis;
      if (std::max(a, b) < crossing.far) crossing.far = std::max(a, b), crossing.far_axis = axis;
    }
    return crossing;
  }
  Seen seen(int column, int row) const {
    const auto along = direction(column, row);
    if (!(along[1] < 0)) return {};
    const double t = (floor_y - eye_[1]) / along[1];
    const double x = eye_[0] + t * along[0], z = eye_[2] + t;
    const Crossing roof = cross(along, bottom);
    const bool hidden = roof.near < roof.far && roof.far > 0 && roof.near < t;
    return {z < floor_end && !hidden, std::abs(x) < half && std::abs(z) < half, t};
  }
  /// Faces behind the floor: left minus entered.
  int count(int column, int row, double floor, const Volume& volume) const {
    const Crossing crossing = cross(direction(column, row), top - volume.length);
    if (!(crossing.near < crossing.far)) return 0;
    const auto counts = [&](double t, int axis) {
      return t > floor && t < volume.far && (volume.caps || axis != 1) ? 1 : 0;
    };
    return counts(crossing.far, crossing.far_axis) - counts(crossing.near, crossing.near_axis);
  }

  std::array<double, 3> eye_;
};

TEST(StabilityShadows, DepthFailNeedsItsCaps) {
  const Curve curve("z-fail-caps");
  const ColumnOnFloor outside({0.2, 3, -18}), inside({0.2, 0.3, -2.5});
  constexpr double pixels = 0.2;  // some whose centre lies right on an edge
  const std::string from_outside = "no caps, camera outside", from_inside = "no caps, camera inside";
  for (const double length : {4.0, 6.0, 8.0, 9.0, 10.0})
    EXPECT_NEAR(curve.naive(from_outside, length), outside.wrong({.length = length, .caps = false}), pixels) << length;
  for (const double length : {3.4, 4.2, 5.0})
    EXPECT_NEAR(curve.naive(from_inside, length), inside.wrong({.length = length, .caps = false}), pixels) << length;
  for (const double length : {1.5, 3.0, 4.0, 10.0})
    EXPECT_NEAR(curve.naive("short volume", length), outside.wrong({.length = length}), pixels) << length;
  for (const double far : {10.0, 17.0, 20.0, 40.0, 1000.0})
    EXPECT_NEAR(curve.naive("far plane", far), outside.wrong({.far = far, .floor_limit = far}), pixels) << far;
  curve.expect_all_robust_zero();
  curve.expect_naive(from_outside, 9, 1.4);
  curve.expect_naive(from_inside, 4.2, 14.3);
  curve.expect_naive("short volume", 1.5, 3.6);
  curve.expect_naive("far plane", 20, 18.8);
  EXPECT_EQ(curve.naive("far plane", 1000), 0);
}

TEST(StabilityShadows, StencilCountsWrap) {
  const Curve curve("stencil-bits-wrap");
  for (const double boards : {1.0, 8.0, 15.0, 17.0}) EXPECT_EQ(curve.naive("4 bits", boards), 0) << boards;
  EXPECT_EQ(curve.naive("4 bits", 16), 100);
  EXPECT_EQ(curve.naive("8 bits", 256), 100);
  curve.expect_all_robust_zero();
}

}  // namespace
