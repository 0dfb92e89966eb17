#include "image/metrics.h"

#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "image/display.h"
#include "image/flip.h"
#include "image/mixing.h"
#include "image/ssim.h"

namespace ps {
namespace {

void require_same_size(int width_a, int height_a, int width_b, int height_b) {
  if (width_a == width_b && height_a == height_b) return;
  throw InputError(fmt::format("found pictures of {} x {} and {} x {}, expected two of the same size", width_a,
                               height_a, width_b, height_b));
}

bool finite(const Vec3d& c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }
bool same(double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); }

Vec3d channels(const Rgb8& c) { return {c.r, c.g, c.b}; }
Vec3d channels(const Vec3f& c) { return Vec3d(c); }
Vec3d channels(const Vec3d& c) { return c; }

/// Mean of the similarities of the three channels, so that a wrong hue counts too.
double colour_ssim(const Image<Vec3d>& a, const Image<Vec3d>& b, double range) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    ScalarImage plane_a(a.width(), a.height());
    ScalarImage plane_b(a.width(), a.height());
    for (std::size_t i = 0; i < plane_a.pixels().size(); ++i) {
      plane_a.pixels()[i] = a.pixels()[i][c];
      plane_b.pixels()[i] = b.pixels()[i][c];
    }
    sum += ssim(plane_a, plane_b, range);
  }
  return sum / 3;
}

/// Sums over the pixels that are finite in both pictures.
struct Sums {
  double absolute = 0, squared = 0, largest = 0;
  std::int64_t values = 0;

  void add(const Vec3d& a, const Vec3d& b) {
    for (int c = 0; c < 3; ++c) {
      const double error = std::abs(a[c] - b[c]);
      absolute += error;
      squared += error * error;
      largest = std::max(largest, error);
      ++values;
    }
  }

  void report(double range, Comparison& result) const {
    result.max = largest;
    if (values == 0) return;
    result.mae = absolute / static_cast<double>(values);
    result.rmse = std::sqrt(squared / static_cast<double>(values));
    if (result.rmse > 0) result.psnr = 20 * std::log10(range / result.rmse);
  }
};

}  // namespace

template <class Colour>
Comparison compare_channels(const Image<Colour>& a, const Image<Colour>& b) {
  require_same_size(a.width(), a.height(), b.width(), b.height());
  constexpr double range = std::is_same_v<Colour, Rgb8> ? 255 : 1;
  Comparison result;
  Sums sums;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Vec3d p = channels(a.pixels()[i]), q = channels(b.pixels()[i]);
    if (!(same(p.r, q.r) && same(p.g, q.g) && same(p.b, q.b))) ++result.differing;
    if (finite(p) && finite(q))
      sums.add(p, q);
    else
      ++result.not_finite;
  }
  sums.report(range, result);
  result.identical = result.identical_levels = result.differing == 0;
  return result;
}
template Comparison compare_channels(const Image<Rgb8>& a, const Image<Rgb8>& b);
template Comparison compare_channels(const Image<Vec3f>& a, const Image<Vec3f>& b);
template Comparison compare_channels(const Image<Vec3d>& a, const Image<Vec3d>& b);

Comparison compare_images(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  Comparison result = compare_channels(a, b);
  if (result.identical) return result;
  Image<Vec3d> levels_a(a.width(), a.height());
  Image<Vec3d> levels_b(a.width(), a.height());
  for (std::size_t i = 0; i < levels_a.pixels().size(); ++i) {
    levels_a.pixels()[i] = channels(a.pixels()[i]);
    levels_b.pixels()[i] = channels(b.pixels()[i]);
  }
  result.ssim = colour_ssim(levels_a, levels_b, 255);
  result.flip = flip(a, b);
  return result;
}

AlphaDifference compare_alpha(const Image<float>& a, const Image<float>& b) {
  AlphaDifference result;
  const auto alpha = [](const Image<float>& image, std::size_t i) {
    return image.empty() ? 1.0 : static_cast<double>(image.pixels()[i]);
  };
  for (std::size_t i = 0; i < std::max(a.pixels().size(), b.pixels().size()); ++i) {
    const double difference = std::abs(alpha(a, i) - alpha(b, i));
    result.differing += difference > 0 ? 1 : 0;
    result.max = std::max(result.max, difference);
  }
  return result;
}

Comparison compare_linear(const Image<Vec3f>& a, const Image<Vec3f>& b) {
  Comparison result = compare_channels(a, b);
  if (result.identical) return result;
  result.identical_levels = display_image(a) == display_image(b);
  Image<Vec3d> shown_a(a.width(), a.height());
  Image<Vec3d> shown_b(a.width(), a.height());
  for (std::size_t i = 0; i < shown_a.pixels().size(); ++i) {
    const Vec3d p = channels(a.pixels()[i]), q = channels(b.pixels()[i]);
    if (!finite(p) || !finite(q)) continue;  // black in both
    shown_a.pixels()[i] = clamp_colour(p);
    shown_b.pixels()[i] = clamp_colour(q);
  }
  result.ssim = colour_ssim(shown_a, shown_b, 1);
  result.flip = flip(shown_a, shown_b);
  return result;
}

}  // namespace ps
