#include "image/difference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "base/check.h"
#include "image/flip.h"
#include "image/heat_colour.h"

namespace ps {
namespace {

constexpr double whole_range = 255, one_per_cent = 0.01 * whole_range;
constexpr double most_gain = 256;

void require_equal_size(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  if (a.width() != b.width() || a.height() != b.height())
    throw InputError(fmt::format("found pictures of {} x {} and {} x {}, expected two of the same size", a.width(),
                                 a.height(), b.width(), b.height()));
}

std::array<int, 3> levels_of(Rgb8 colour) { return {colour.r, colour.g, colour.b}; }

/// The difference of the channel in which both differ most.
float signed_difference(Rgb8 a, Rgb8 b) {
  const auto from = levels_of(a), to = levels_of(b);
  int most = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(to[i] - from[i]) > std::abs(most)) most = to[i] - from[i];
  return static_cast<float>(most);
}

float relative_difference(Rgb8 a, Rgb8 b) {
  const auto from = levels_of(a), to = levels_of(b);
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(to[i] - from[i]) / (from[i] + one_per_cent));
  return static_cast<float>(most);
}

std::uint8_t stored(double level) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0, whole_range)));
}

/// From black over `colour` in the middle to white.
Rgb8 through(Rgb8 colour, double t) {
  const auto middle = levels_of(colour);
  std::array<std::uint8_t, 3> mixed{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = middle[i];
    mixed[i] = stored(t < 0.5 ? part * 2 * t : part + (whole_range - part) * (2 * t - 1));
  }
  return {mixed[0], mixed[1], mixed[2]};
}

}  // namespace

int largest_difference(Rgb8 a, Rgb8 b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

double full_scale(DifferenceMode mode) {
  switch (mode) {
  case DifferenceMode::absolute:
  case DifferenceMode::sign:
    return whole_range;
  case DifferenceMode::relative:
  case DifferenceMode::flip:
    return 1;
  }
  return 1;
}

Image<float> difference_values(const Image<Rgb8>& a, const Image<Rgb8>& b, DifferenceMode mode) {
  require_equal_size(a, b);
  Image<float> values(a.width(), a.height());
  const auto each = [&](auto&& value) {
    std::transform(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), values.pixels().begin(), value);
  };
  switch (mode) {
  case DifferenceMode::absolute:
    each([](Rgb8 x, Rgb8 y) { return static_cast<float>(largest_difference(x, y)); });
    break;
  case DifferenceMode::sign:
    each(signed_difference);
    break;
  case DifferenceMode::relative:
    each(relative_difference);
    break;
  case DifferenceMode::flip: {
    const ScalarImage map = flip_map(a, b);
    std::transform(map.pixels().begin(), map.pixels().end(), values.pixels().begin(),
                   [](double value) { return static_cast<float>(value); });
    break;
  }
  }
  return values;
}

DifferenceNumbers difference_numbers(const Image<float>& values, const std::optional<TileRect>& region) {
  const TileRect part = region.value_or(TileRect{0, 0, values.width(), values.height()});
  DifferenceNumbers numbers;
  std::vector<float> sizes;
  for (int y = std::max(part.y0, 0); y < std::min(part.y1, values.height()); ++y)
    for (int x = std::max(part.x0, 0); x < std::min(part.x1, values.width()); ++x) {
      const float size = std::abs(values.at(x, y));
      sizes.push_back(size);
      numbers.mean += size;
      numbers.differing += size > 0;
      if (size > numbers.largest) numbers.largest = size, numbers.at = {x, y};
    }
  if (sizes.empty()) return numbers;
  const auto count = static_cast<double>(sizes.size());
  numbers.mean /= count;
  numbers.differing /= count;
  const auto place = static_cast<std::ptrdiff_t>(std::ceil(0.999 * count)) - 1;
  std::nth_element(sizes.begin(), sizes.begin() + place, sizes.end());
  numbers.percentile = sizes[static_cast<std::size_t>(place)];
  return numbers;
}

double gain_that_shows(const DifferenceNumbers& numbers, DifferenceMode mode) {
  const double white = numbers.percentile > 0 ? numbers.percentile : numbers.largest;
  return white > 0 ? std::clamp(full_scale(mode) / white, 1.0, most_gain) : 1;
}

Rgb8 difference_pixel(Rgb8 a, Rgb8 b, double gain) {
  const auto level = [&](int x, int y) { return stored(std::abs(y - x) * gain); };
  return {level(a.r, b.r), level(a.g, b.g), level(a.b, b.b)};
}

Rgb8 difference_colour(double value, const DifferenceOptions& options) {
  constexpr Rgb8 of_a{0, 114, 178}, of_b{213, 94, 0};  // as the window marks A and B
  const double t = std::clamp(std::abs(value) * options.gain / full_scale(options.mode), 0.0, 1.0);
  switch (options.mode) {
  case DifferenceMode::absolute:
    return {stored(t * whole_range), stored(t * whole_range), stored(t * whole_range)};
  case DifferenceMode::sign:
    return through(value < 0 ? of_a : of_b, t);
  case DifferenceMode::relative:
  case DifferenceMode::flip:
    return heat_colour(t);
  }
  return {};
}

Image<Rgb8> difference_picture(const Image<float>& values, const DifferenceOptions& options) {
  PS_ASSERT(options.mode != DifferenceMode::absolute, "it shows each channel");
  Image<Rgb8> result(values.width(), values.height());
  std::transform(values.pixels().begin(), values.pixels().end(), result.pixels().begin(),
                 [&](float value) { return difference_colour(value, options); });
  return result;
}

Image<Rgb8> difference_picture(const Image<Rgb8>& a, const Image<Rgb8>& b, const DifferenceOptions& options) {
  if (options.mode != DifferenceMode::absolute)
    return difference_picture(difference_values(a, b, options.mode), options);
  require_equal_size(a, b);
  Image<Rgb8> result(a.width(), a.height());
  std::transform(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), result.pixels().begin(),
                 [&](Rgb8 x, Rgb8 y) { return difference_pixel(x, y, options.gain); });
  return result;
}

}  // namespace ps
