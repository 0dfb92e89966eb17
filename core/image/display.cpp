#include "image/display.h"

#include <algorithm>
#include <bit>

#include "image/display_levels.h"
#include "image/gamma_curve.h"
#include "math/has_nan.h"

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

std::uint8_t shown(double value, unsigned highest) { return expand(quantise(value * highest, highest), highest); }

/// The largest value that each channel is quantised to.
struct Highest {
  unsigned r, g, b;
};

Highest highest_levels(ColourDepth depth) {
  switch (depth) {
  case ColourDepth::bits24:
    return {255, 255, 255};
  case ColourDepth::bits16:
    return {31, 63, 31};
  case ColourDepth::bits15:
    return {31, 31, 31};
  }
  return {};
}

Rgb8 curved_pixel(const Vec3d& linear, double exposure, const GammaCurve& curve_rb, const GammaCurve& curve_g) {
  return {expand(curve_rb.level(linear.r * exposure), curve_rb.highest()),
          expand(curve_g.level(linear.g * exposure), curve_g.highest()),
          expand(curve_rb.level(linear.b * exposure), curve_rb.highest())};
}

template <class Pixel>
void display_run(std::span<const Pixel> linear, std::span<Rgb8> levels, const DisplayTransform& transform) {
  PS_ASSERT(linear.size() == levels.size(), "one level for each colour");
  if (transform.gamma == 1 && transform.depth == ColourDepth::bits24) {
    const double exposure = transform.exposure;
    if constexpr (std::is_same_v<Pixel, Vec3f> && sizeof(Vec3f) == 3 * sizeof(float) && sizeof(Rgb8) == 3) {
      if (!linear.empty()) display_levels(&linear[0].x, 3 * linear.size(), exposure, &levels[0].r);
      return;
    }
    for (std::size_t i = 0; i < linear.size(); ++i)
      levels[i] = {level8(linear[i].r, exposure), level8(linear[i].g, exposure), level8(linear[i].b, exposure)};
    return;
  }
  if (transform.gamma == 1) {
    for (std::size_t i = 0; i < linear.size(); ++i) levels[i] = display_pixel(Vec3d(linear[i]), transform);
    return;
  }
  const Highest highest = highest_levels(transform.depth);
  const GammaCurve& curve_rb = gamma_curve(transform.gamma, highest.r);
  const GammaCurve& curve_g = gamma_curve(transform.gamma, highest.g);
  for (std::size_t i = 0; i < linear.size(); ++i)
    levels[i] = curved_pixel(Vec3d(linear[i]), transform.exposure, curve_rb, curve_g);
}

template <class Pixel>
Image<Rgb8> display_all(const Image<Pixel>& linear, const DisplayTransform& transform) {
  Image<Rgb8> levels(linear.width(), linear.height());
  display_run<Pixel>(linear.pixels(), levels.pixels(), transform);
  return levels;
}

template <class Pixel>
std::uint64_t count_nan(const Image<Pixel>& linear) {
  return static_cast<std::uint64_t>(
      std::count_if(linear.pixels().begin(), linear.pixels().end(), [](const Pixel& c) { return has_nan(c); }));
}

}  // namespace

Rgb8 display_pixel(const Vec3d& linear, const DisplayTransform& transform) {
  const Highest highest = highest_levels(transform.depth);
  if (transform.gamma == 1) {
    const Vec3d exposed = linear * transform.exposure;
    return {shown(exposed.r, highest.r), shown(exposed.g, highest.g), shown(exposed.b, highest.b)};
  }
  const GammaCurve& curve_rb = gamma_curve(transform.gamma, highest.r);
  const GammaCurve& curve_g = gamma_curve(transform.gamma, highest.g);
  return curved_pixel(linear, transform.exposure, curve_rb, curve_g);
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
