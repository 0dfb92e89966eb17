#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "math/portable.h"
#include "math/unit.h"
#include "raytrace/sampling/pattern.h"

namespace ps {

/// The disc that a lamp, a ball of light, shows to a point: around its centre, perpendicular to the direction from the
/// point. Shadow rays end on it (Cook, Porter and Carpenter 1984). `to_light` leads from the point to the centre.
template <class Real>
class LampDisc {
 public:
  LampDisc(const Vec3<Real>& to_light, Real radius) : to_centre_(to_light) {
    const Vec3<Real> n = unit_of(to_light);
    const Vec3<Real> size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    const Vec3<Real> aside = size.x <= size.y && size.x <= size.z ? Vec3<Real>{1, 0, 0}
                             : size.y <= size.z                   ? Vec3<Real>{0, 1, 0}
                                                                  : Vec3<Real>{0, 0, 1};
    right_ = unit_of(cross(n, aside)) * radius;
    up_ = cross(n, right_);
  }

  /// Towards a point of the disc. The unit square becomes the disc so that equal areas stay equal: x turns, the square
  /// root of y leads outwards.
  Vec3<Real> towards(const Vec2d& square) const {
    const double reach = std::sqrt(square.y), angle = 2 * std::numbers::pi * square.x;
    return to_centre_ + right_ * static_cast<Real>(reach * portable::cos(angle)) +
           up_ * static_cast<Real>(reach * portable::sin(angle));
  }

 private:
  Vec3<Real> to_centre_, right_{0}, up_{0};
};

/// In place of a pixel a point chooses its random numbers by its coordinates, and by the light. They depend
/// neither on threads nor on the order of rays.
template <class Real>
inline Vec2i pattern_place(const Vec3<Real>& point, int light) {
  const Vec3f p(point);
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  const std::uint32_t x = bits(p.x) ^ std::rotl(bits(p.z), 16),
                      y = bits(p.y) + 0x9e3779b9u * static_cast<std::uint32_t>(light);
  return {static_cast<int>(x), static_cast<int>(y)};
}

}  // namespace ps
