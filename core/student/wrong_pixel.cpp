#include "student/wrong_pixel.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "base/check.h"

namespace ps {
namespace {

bool same_number(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

bool same_colour(const Vec3d& a, const Vec3d& b) {
  return same_number(a.x, b.x) && same_number(a.y, b.y) && same_number(a.z, b.z);
}

}  // namespace

WrongPixels wrong_pixels(const Image<Vec3d>& own, const Image<Vec3d>& right) {
  if (own.width() != right.width() || own.height() != right.height())
    throw InputError(fmt::format("found a picture of {} x {} pixels, expected one of {} x {}", own.width(),
                                 own.height(), right.width(), right.height()));
  WrongPixels wrong;
  for (int y = 0; y < own.height(); ++y)
    for (int x = 0; x < own.width(); ++x) {
      if (same_colour(own.at(x, y), right.at(x, y))) continue;
      if (wrong.count++ > 0) continue;
      wrong.first = {x, y};
      wrong.own = own.at(x, y);
      wrong.right = right.at(x, y);
    }
  return wrong;
}

}  // namespace ps
