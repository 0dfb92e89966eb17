#include "scene/rotation.h"

#include <numbers>
#include <string>

#include <fmt/format.h>

#include "base/number_text.h"
#include "math/portable.h"

namespace ps {
namespace {

using std::numbers::pi;

}  // namespace

Mat3d rotation_about(Axis axis, double degrees) {
  const double c = portable::cos(degrees * pi / 180);
  const double s = portable::sin(degrees * pi / 180);
  switch (axis) {
  case Axis::x:
    return from_rows({1, 0, 0}, {0, c, s}, {0, -s, c});
  case Axis::y:
    return from_rows({c, 0, -s}, {0, 1, 0}, {s, 0, c});
  case Axis::z:
    return from_rows({c, s, 0}, {-s, c, 0}, {0, 0, 1});
  }
  return Mat3d(1.0);
}

std::optional<AxisAngle> axis_angle_of(const Mat3d& rotation) {
  for (const Axis axis : {Axis::y, Axis::x, Axis::z}) {
    // The cosine and sine are in the same places of every rotation about this axis.
    const Vec3d row = row_of(rotation, axis == Axis::x ? 1 : 0);
    const double cosine = axis == Axis::x ? row.y : row.x;
    const double sine = axis == Axis::y ? -row.z : (axis == Axis::x ? row.z : row.y);
    const double exact = portable::atan2(sine, cosine) * 180 / pi;
    // People write angles with few digits, and those do not survive the arc tangent: the shortest that fits is theirs.
    for (const int digits : {4, 7, 10, 13, 15, 17}) {
      const double degrees = parse_number(fmt::format("{:.{}g}", exact, digits)).value_or(0);
      if (rotation_about(axis, degrees) == rotation) return AxisAngle{axis, degrees};
    }
  }
  return {};
}

Mat3d from_rows(const Vec3d& first, const Vec3d& second, const Vec3d& third) {
  return {first.x, second.x, third.x, first.y, second.y, third.y, first.z, second.z, third.z};
}

Vec3d row_of(const Mat3d& matrix, int row) { return {matrix[0][row], matrix[1][row], matrix[2][row]}; }

}  // namespace ps
