#include "raytrace/sampling/pattern.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "base/check.h"

namespace ps {
namespace {

/// A well-mixed 32-bit number of all arguments (two rounds of the finaliser "lowbias32" by C. Wellons).
std::uint32_t mixed(std::uint32_t a, std::uint32_t b) {
  std::uint32_t h = a * 0x9e3779b9u + b;
  for (int round = 0; round < 2; ++round) {
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    h ^= h >> 16;
    h += 0x9e3779b9u;
  }
  return h;
}

double unit_number(std::uint32_t bits) { return bits * 0x1p-32; }

/// Two numbers in [0, 1) that belong to this sample of this pixel.
Vec2d random_pair(Vec2i pixel, int index) {
  const std::uint32_t place = mixed(static_cast<std::uint32_t>(pixel.x), static_cast<std::uint32_t>(pixel.y));
  const std::uint32_t first = mixed(place, 2 * static_cast<std::uint32_t>(index));
  return {unit_number(first), unit_number(mixed(place, 2 * static_cast<std::uint32_t>(index) + 1))};
}

/// The digits of `index` in `base` mirrored about the point.
double radical_inverse(std::uint32_t index, std::uint32_t base) {
  double value = 0, digit = 1;
  for (; index > 0; index /= base) {
    digit /= base;
    value += digit * (index % base);
  }
  return value;
}

/// The sum without its whole part; never 1, whatever rounding does.
double wrapped(double value) {
  const double rest = value - std::floor(value);
  return rest < 1 ? rest : 0;
}

/// The cell of the grid that sample `index` fills: its corner and its size.
struct Cell {
  Vec2d corner{0, 0}, size{1, 1};
};

Cell grid_cell(int index, int count) {
  const int rows = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count))));
  // Row r holds samples [r count / rows, (r + 1) count / rows).
  const auto begin_of = [&](int r) { return static_cast<int>(static_cast<std::int64_t>(r) * count / rows); };
  int row = static_cast<int>(static_cast<std::int64_t>(index) * rows / count);
  while (begin_of(row + 1) <= index) ++row;
  while (begin_of(row) > index) --row;
  const int begin = begin_of(row);
  const double columns = begin_of(row + 1) - begin, all = count;
  return {{(index - begin) / columns, begin / all}, {1 / columns, columns / all}};
}

/// 1 / g and 1 / g^2 with g^3 = g + 1.
constexpr std::array<double, 2> plastic{0.75487766624669276, 0.56984029099805327};

}  // namespace

Vec2d sample_in_square(SamplePattern pattern, int index, int count, Vec2i pixel) {
  PS_ASSERT(index >= 0 && index < count, "a sample of the pixel");
  const auto shifted = [&](double x, double y) {
    const Vec2d shift = random_pair(pixel, -1);
    return Vec2d{wrapped(x + shift.x), wrapped(y + shift.y)};
  };
  switch (pattern) {
  case SamplePattern::grid: {
    const Cell cell = grid_cell(index, count);
    return cell.corner + cell.size * 0.5;
  }
  case SamplePattern::jitter: {
    const Cell cell = grid_cell(index, count);
    const Vec2d place = cell.corner + cell.size * random_pair(pixel, index);
    return {wrapped(place.x), wrapped(place.y)};
  }
  case SamplePattern::random:
    return random_pair(pixel, index);
  case SamplePattern::halton: {
    const auto number = static_cast<std::uint32_t>(index);
    return shifted(radical_inverse(number, 2), radical_inverse(number, 3));
  }
  case SamplePattern::r2:
    return shifted(index * plastic[0], index * plastic[1]);
  }
  return {0.5, 0.5};
}

Vec2d sample_in_pixel(SamplePattern pattern, int index, int count, Vec2i pixel, const Vec2d& middle) {
  const Vec2d from_middle = sample_in_square(pattern, index, count, pixel) - Vec2d{0.5, 0.5};
  return middle + from_middle;
}

}  // namespace ps
