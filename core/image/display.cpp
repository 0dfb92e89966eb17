#include "image/display.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "math/power.h"

namespace ps {
namespace {

/// Nearest integer of a value in [0, highest], ties to even. Anything below, and NaN, gives 0; above gives `highest`.
inline unsigned quantise(double value, double highest) {
  const double clamped = value > 0 ? (value < highest ? value : highest) : 0;  // false for NaN
  // Adding 2^52 leaves no bits behind the point, so the processor rounds, half to even; the integer is in the low bits.
  return static_cast<unsigned>(std::bit_cast<std::uint64_t>(clamped + 0x1p52) & 0xffff);
}

/// q of `highest` expanded to 8 bits, nearest (no ties: highest is odd).
inline std::uint8_t expand(unsigned q, unsigned highest) {
  return static_cast<std::uint8_t>((q * 510 + highest) / (2 * highest));
}

/// A curve-free transform of one channel: the common case, kept free of calls so that it vectorises.
inline std::uint8_t level8(double linear, double exposure) {
  return static_cast<std::uint8_t>(quantise(linear * exposure * 255, 255));
}

double curved(double linear, const DisplayTransform& transform) {
  const double exposed = linear * transform.exposure;
  if (transform.gamma == 1) return exposed;
  return exposed > 0 ? power(std::min(exposed, 1.0), 1 / transform.gamma) : 0;  // 0 for NaN
}

std::uint8_t shown(double value, unsigned highest) { return expand(quantise(value * highest, highest), highest); }

template <class Pixel>
void display_run(std::span<const Pixel> linear, std::span<Rgb8> levels, const DisplayTransform& transform) {
  PS_ASSERT(linear.size() == levels.size(), "one level for each colour");
  if (transform.gamma == 1 && transform.depth == ColourDepth::bits24) {
    const double exposure = transform.exposure;
    for (std::size_t i = 0; i < linear.size(); ++i)
      levels[i] = {level8(linear[i].r, exposure), level8(linear[i].g, exposure), level8(linear[i].b, exposure)};
    return;
  }
  for (std::size_t i = 0; i < linear.size(); ++i) levels[i] = display_pixel(Vec3d(linear[i]), transform);
}

template <class Pixel>
Image<Rgb8> display_all(const Image<Pixel>& linear, const DisplayTransform& transform) {
  Image<Rgb8> levels(linear.width(), linear.height());
  display_run<Pixel>(linear.pixels(), levels.pixels(), transform);
  return levels;
}

template <class Pixel>
std::uint64_t count_nan(const Image<Pixel>& linear) {
  return static_cast<std::uint64_t>(std::count_if(linear.pixels().begin(), linear.pixels().end(), [](const Pixel& c) {
    return std::isnan(c.r) || std::isnan(c.g) || std::isnan(c.b);
  }));
}

}  // namespace

DisplayTransform display_transform(const Settings& settings) {
  return {settings.exposure, settings.gamma, settings.colour_depth};
}

Rgb8 display_pixel(const Vec3d& linear, const DisplayTransform& transform) {
  const double r = curved(linear.r, transform);
  const double g = curved(linear.g, transform);
  const double b = curved(linear.b, transform);
  switch (transform.depth) {
  case ColourDepth::bits24:
    return {shown(r, 255), shown(g, 255), shown(b, 255)};
  case ColourDepth::bits16:
    return {shown(r, 31), shown(g, 63), shown(b, 31)};
  case ColourDepth::bits15:
    return {shown(r, 31), shown(g, 31), shown(b, 31)};
  }
  return {};
}

Image<Rgb8> display_image(const Image<Vec3f>& linear, const DisplayTransform& transform) {
  return display_all(linear, transform);
}
Image<Rgb8> display_image(const Image<Vec3d>& linear, const DisplayTransform& transform) {
  return display_all(linear, transform);
}

void display_row(std::span<const Vec3f> linear, std::span<Rgb8> levels, const DisplayTransform& transform) {
  display_run(linear, levels, transform);
}
void display_row(std::span<const Vec3d> linear, std::span<Rgb8> levels, const DisplayTransform& transform) {
  display_run(linear, levels, transform);
}

std::uint64_t count_nan_pixels(const Image<Vec3f>& linear) { return count_nan(linear); }
std::uint64_t count_nan_pixels(const Image<Vec3d>& linear) { return count_nan(linear); }

Image<Vec3f> to_unit(const Image<Rgb8>& levels) {
  Image<Vec3f> unit(levels.width(), levels.height());
  std::transform(levels.pixels().begin(), levels.pixels().end(), unit.pixels().begin(),
                 [](Rgb8 c) { return Vec3f(c.r, c.g, c.b) / 255.0f; });
  return unit;
}

}  // namespace ps
