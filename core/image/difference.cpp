#include "image/difference.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ps {
namespace {

std::uint8_t difference_level(int a, int b, const DifferenceOptions& options) {
  const double gained = (b - a) * options.gain;
  switch (options.mode) {
  case DifferenceMode::absolute:
    return static_cast<std::uint8_t>(std::lround(std::clamp(std::abs(gained), 0.0, 255.0)));
  case DifferenceMode::sign:
    return static_cast<std::uint8_t>(std::lround(std::clamp(128 + gained / 2, 0.0, 255.0)));
  }
  return 0;
}

}  // namespace

Rgb8 difference_pixel(Rgb8 a, Rgb8 b, const DifferenceOptions& options) {
  return {difference_level(a.r, b.r, options), difference_level(a.g, b.g, options),
          difference_level(a.b, b.b, options)};
}

Image<Rgb8> difference_picture(const Image<Rgb8>& a, const Image<Rgb8>& b, const DifferenceOptions& options) {
  if (a.width() != b.width() || a.height() != b.height())
    throw InputError(fmt::format("found pictures of {} x {} and {} x {}, expected two of the same size", a.width(),
                                 a.height(), b.width(), b.height()));
  Image<Rgb8> result(a.width(), a.height());
  std::transform(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), result.pixels().begin(),
                 [&](Rgb8 x, Rgb8 y) { return difference_pixel(x, y, options); });
  return result;
}

}  // namespace ps
