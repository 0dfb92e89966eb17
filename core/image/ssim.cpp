#include "image/ssim.h"

#include <cmath>

namespace ps {
namespace {

constexpr int window_radius = 5;

Kernel gaussian_window() {
  constexpr double sigma = 1.5;
  Kernel kernel;
  double sum = 0;
  for (int i = -window_radius; i <= window_radius; ++i) {
    kernel.push_back(std::exp(-i * i / (2 * sigma * sigma)));
    sum += kernel.back();
  }
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

ScalarImage product(const ScalarImage& a, const ScalarImage& b) {
  ScalarImage result(a.width(), a.height());
  for (std::size_t i = 0; i < result.pixels().size(); ++i) result.pixels()[i] = a.pixels()[i] * b.pixels()[i];
  return result;
}

}  // namespace

double ssim(const ScalarImage& a, const ScalarImage& b, double range) {
  PS_ASSERT(a.width() == b.width() && a.height() == b.height() && !a.empty(), "planes of one size");
  const Kernel window = gaussian_window();
  const auto blurred = [&](const ScalarImage& plane) { return filtered(plane, window, window); };
  const ScalarImage mean_a = blurred(a);
  const ScalarImage mean_b = blurred(b);
  const ScalarImage square_a = blurred(product(a, a));
  const ScalarImage square_b = blurred(product(b, b));
  const ScalarImage cross = blurred(product(a, b));
  const double c1 = 0.01 * range * (0.01 * range);
  const double c2 = 0.03 * range * (0.03 * range);

  const bool inside = a.width() > 2 * window_radius && a.height() > 2 * window_radius;
  const int margin = inside ? window_radius : 0;
  double sum = 0;
  std::int64_t windows = 0;
  for (int y = margin; y < a.height() - margin; ++y) {
    for (int x = margin; x < a.width() - margin; ++x) {
      const double ma = mean_a.at(x, y);
      const double mb = mean_b.at(x, y);
      const double variance_a = square_a.at(x, y) - ma * ma;
      const double variance_b = square_b.at(x, y) - mb * mb;
      const double covariance = cross.at(x, y) - ma * mb;
      sum += (2 * ma * mb + c1) * (2 * covariance + c2) / ((ma * ma + mb * mb + c1) * (variance_a + variance_b + c2));
      ++windows;
    }
  }
  return sum / static_cast<double>(windows);
}

}  // namespace ps
