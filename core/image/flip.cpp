#include "image/flip.h"

#include <array>
#include <cmath>
#include <numbers>

#include "image/flip_colour.h"

namespace ps {
namespace {

using flip_colour::hunt_lab;
using flip_colour::hyab;

/// A sum of Gaussians a * sqrt(pi / b) * exp(-pi^2 d^2 / b), d in degrees: how far the eye blurs one opponent channel.
struct Sensitivity {
  std::array<double, 2> a;
  std::array<double, 2> b;
};
constexpr Sensitivity achromatic{{1, 0}, {0.0047, 1e-5}};
constexpr Sensitivity red_green{{1, 0}, {0.0053, 1e-5}};
constexpr Sensitivity blue_yellow{{34.1, 13.5}, {0.04, 0.025}};
constexpr double widest_b = 0.04;

ScalarImage channel(const Image<Vec3d>& image, int index) {
  ScalarImage plane(image.width(), image.height());
  for (std::size_t i = 0; i < plane.pixels().size(); ++i) plane.pixels()[i] = image.pixels()[i][index];
  return plane;
}

/// Blurs one channel; the weights of all Gaussians together add up to 1 over the square window.
ScalarImage blurred(const ScalarImage& plane, const Sensitivity& sensitivity, double ppd) {
  constexpr double pi = std::numbers::pi;
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest_b / (2 * pi * pi)) * ppd));
  ScalarImage sum(plane.width(), plane.height());
  double total = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    if (sensitivity.a[k] == 0) continue;
    const double b = sensitivity.b[k];
    Kernel kernel;
    double weights = 0;
    for (int i = -radius; i <= radius; ++i) {
      const double degrees = i / ppd;
      kernel.push_back(std::exp(-pi * pi * degrees * degrees / b));
      weights += kernel.back();
    }
    const double factor = sensitivity.a[k] * std::sqrt(pi / b);
    total += factor * weights * weights;
    const ScalarImage part = filtered(plane, kernel, kernel);
    for (std::size_t i = 0; i < sum.pixels().size(); ++i) sum.pixels()[i] += factor * part.pixels()[i];
  }
  for (double& value : sum.pixels()) value /= total;
  return sum;
}

Image<Vec3d> opponents(const Image<Vec3d>& rgb) {
  Image<Vec3d> result(rgb.width(), rgb.height());
  std::transform(rgb.pixels().begin(), rgb.pixels().end(), result.pixels().begin(), flip_colour::opponent);
  return result;
}

/// The picture as the eye resolves it, in Hunt-adjusted CIELAB.
Image<Vec3d> perceived(const Image<Vec3d>& opponent, double ppd) {
  const ScalarImage y = blurred(channel(opponent, 0), achromatic, ppd);
  const ScalarImage cx = blurred(channel(opponent, 1), red_green, ppd);
  const ScalarImage cz = blurred(channel(opponent, 2), blue_yellow, ppd);
  Image<Vec3d> lab(opponent.width(), opponent.height());
  for (std::size_t i = 0; i < lab.pixels().size(); ++i) {
    const Vec3d rgb = flip_colour::rgb_of_opponent({y.pixels()[i], cx.pixels()[i], cz.pixels()[i]});
    lab.pixels()[i] = hunt_lab(glm::clamp(rgb, 0.0, 1.0));
  }
  return lab;
}

/// Colour difference to the power 0.7, spread over [0, 1]: the lower 40 % of the possible range fill 95 % of it.
double colour_difference(const Vec3d& a, const Vec3d& b) {
  constexpr double exponent = 0.7, knee_in = 0.4, knee_out = 0.95;
  static const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), exponent);
  const double knee = knee_in * largest;
  const double difference = std::pow(hyab(a, b), exponent);
  if (difference < knee) return knee_out / knee * difference;
  return knee_out + (difference - knee) / (largest - knee) * (1 - knee_out);
}

/// Derivatives of a Gaussian: the first finds edges, the second finds points and lines.
struct FeatureKernels {
  Kernel smooth, edge, point;
};

/// Scales positive weights to add up to 1 and negative ones to -1.
void balance(Kernel& kernel) {
  double positive = 0;
  double negative = 0;
  for (const double weight : kernel) (weight > 0 ? positive : negative) += std::abs(weight);
  for (double& weight : kernel) weight /= weight > 0 ? positive : negative;
}

FeatureKernels feature_kernels(double ppd) {
  constexpr double width_in_degrees = 0.082;
  const double sigma = 0.5 * width_in_degrees * ppd;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  FeatureKernels kernels;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) {
    const double gaussian = std::exp(-i * i / (2 * sigma * sigma));
    sum += gaussian;
    kernels.smooth.push_back(gaussian);
    kernels.edge.push_back(-i * gaussian);
    kernels.point.push_back((i * i / (sigma * sigma) - 1) * gaussian);
  }
  for (double& weight : kernels.smooth) weight /= sum;
  balance(kernels.edge);
  balance(kernels.point);
  return kernels;
}

/// How strongly each pixel lies on a feature, whatever its direction.
ScalarImage strength(const ScalarImage& grey, const Kernel& feature, const Kernel& smooth) {
  const ScalarImage x = filtered(grey, feature, smooth);
  const ScalarImage y = filtered(grey, smooth, feature);
  ScalarImage result(grey.width(), grey.height());
  for (std::size_t i = 0; i < result.pixels().size(); ++i)
    result.pixels()[i] = std::hypot(x.pixels()[i], y.pixels()[i]);
  return result;
}

/// The achromatic channel brought to [0, 1].
ScalarImage grey_of(const Image<Vec3d>& opponent) {
  ScalarImage grey = channel(opponent, 0);
  for (double& value : grey.pixels()) value = (value + 16) / 116;
  return grey;
}

}  // namespace

ScalarImage flip_map(const Image<Vec3d>& reference, const Image<Vec3d>& test, const FlipOptions& options) {
  PS_ASSERT(reference.width() == test.width() && reference.height() == test.height(), "pictures of one size");
  const double ppd = options.pixels_per_degree;
  const Image<Vec3d> opponent_a = opponents(reference);
  const Image<Vec3d> opponent_b = opponents(test);
  const Image<Vec3d> lab_a = perceived(opponent_a, ppd);
  const Image<Vec3d> lab_b = perceived(opponent_b, ppd);
  const FeatureKernels kernels = feature_kernels(ppd);
  const ScalarImage grey_a = grey_of(opponent_a);
  const ScalarImage grey_b = grey_of(opponent_b);
  const ScalarImage edges_a = strength(grey_a, kernels.edge, kernels.smooth);
  const ScalarImage edges_b = strength(grey_b, kernels.edge, kernels.smooth);
  const ScalarImage points_a = strength(grey_a, kernels.point, kernels.smooth);
  const ScalarImage points_b = strength(grey_b, kernels.point, kernels.smooth);

  ScalarImage map(reference.width(), reference.height());
  for (std::size_t i = 0; i < map.pixels().size(); ++i) {
    const double colour = colour_difference(lab_a.pixels()[i], lab_b.pixels()[i]);
    const double edge = std::abs(edges_a.pixels()[i] - edges_b.pixels()[i]);
    const double point = std::abs(points_a.pixels()[i] - points_b.pixels()[i]);
    const double feature = std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
    map.pixels()[i] = std::pow(colour, 1 - feature);
  }
  return map;
}

namespace {

double mean_of(const ScalarImage& map) {
  double sum = 0;
  for (const double value : map.pixels()) sum += value;
  return sum / static_cast<double>(map.pixels().size());
}

double srgb_to_linear(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Image<Vec3d> linear_of(const Image<Rgb8>& levels) {
  Image<Vec3d> linear(levels.width(), levels.height());
  std::transform(levels.pixels().begin(), levels.pixels().end(), linear.pixels().begin(), [](const Rgb8& p) {
    return Vec3d(srgb_to_linear(p.r / 255.0), srgb_to_linear(p.g / 255.0), srgb_to_linear(p.b / 255.0));
  });
  return linear;
}

}  // namespace

double flip(const Image<Vec3d>& reference, const Image<Vec3d>& test, const FlipOptions& options) {
  return mean_of(flip_map(reference, test, options));
}

ScalarImage flip_map(const Image<Rgb8>& reference, const Image<Rgb8>& test, const FlipOptions& options) {
  return flip_map(linear_of(reference), linear_of(test), options);
}

double flip(const Image<Rgb8>& reference, const Image<Rgb8>& test, const FlipOptions& options) {
  return mean_of(flip_map(reference, test, options));
}

}  // namespace ps
